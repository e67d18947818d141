// A foreign reader is made of the schema: its comments say what the manual says.
#include "test_paths.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace gw::inspect {
namespace {

std::string text_of(const std::string& file) {
    std::ifstream in(std::string(GW_SOURCE_DIR) + "/" + file);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
}

std::vector<std::smatch> all_matches(const std::string& text, const char* pattern) {
    const std::regex expression(pattern);
    return std::vector<std::smatch>(std::sregex_iterator(text.begin(), text.end(), expression),
                                    std::sregex_iterator());
}

struct SchemaMember {
    std::string type, absent;  ///< absent: what its comment says of it
};

/// The members of one of the schema's tables, by name.
std::map<std::string, SchemaMember> members_of(const std::string& schema, const std::string& name) {
    const std::size_t begin = schema.find("table " + name + " {");
    const std::string table = schema.substr(begin, schema.find('}', begin) - begin);
    std::map<std::string, SchemaMember> out;
    for (const std::smatch& m :
         all_matches(table, R"(\n    (\w+): (\[?\w+\]?)[^;]*;( *//[^\n]*absent: ([^\n]*))?)"))
        out[m[1]] = {m[2], m[4]};
    return out;
}

/// Rule R15.1, with its table.
std::string absent_members() {
    const std::string page = text_of("docs/recordings.md");
    const std::size_t begin = page.find("**[R15.1]**");
    return page.substr(begin, page.find("**[R15.2]**") - begin);
}

const std::string& schema() {
    static const std::string text = text_of("inspect/recording/recording.fbs");
    return text;
}

}  // namespace

// [R5.3]
TEST(SchemaWords, OfAMeshsAbsentMembersAreTheManuals) {
    const std::string page = text_of("docs/manual/commands.md");
    const std::size_t begin = page.find("**[R5.3]**");
    const std::string rule = page.substr(begin, page.find("**[R5.4]**") - begin);
    std::map<std::string, std::string> manual;
    for (const std::smatch& m :
         all_matches(rule, R"(\| `(\w+)` \|[^|\n]*\|[^|\n]*\| ([^|\n]*) \|\n)"))
        manual[m[1]] = m[2];
    const auto mesh = members_of(schema(), "Mesh");
    EXPECT_EQ(mesh.size(), manual.size());
    for (const auto& [name, member] : mesh)
        if (member.type.starts_with("[")) {
            EXPECT_EQ(member.absent, manual[name]) << name;
        }
}

// [R15.1]
TEST(SchemaWords, EveryAbsentStructureHasItsRowInTheManual) {
    std::set<std::string> structures;
    for (const std::smatch& m : all_matches(schema(), R"(\nstruct (\w+) )"))
        structures.insert(m[1]);
    structures.erase("Rect");  // one row for all
    const std::string rule = absent_members();
    for (const std::string table : {"Mesh", "Clear", "Draw", "WriteSpans", "WritePixels", "Copy",
                                    "CopyTexture", "Read", "DrawPixels"})
        for (const auto& [name, member] : members_of(schema(), table))
            if (structures.contains(member.type) ||
                (table == "Mesh" && member.type.starts_with("[") && name != "positions")) {
                EXPECT_NE(rule.find("`" + name + "`"), rule.npos) << table << " " << name;
            }
}

}  // namespace gw::inspect
