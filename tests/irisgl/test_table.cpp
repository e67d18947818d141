// The table of functions, beside the document and the C library.
#include "test_paths.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace {

struct TableRow {
    const char* name;
    const char* kind;
};
#define GW_IRISGL_FUNCTION(name, kind) {#name, #kind},
constexpr TableRow rows[] = {
#include "generated/irisgl/functions.inc"
};
#undef GW_IRISGL_FUNCTION

std::string document() {
    std::ifstream in(std::string(GW_SOURCE_DIR) + "/docs/irisgl.md");
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST(IrisGlTable, TheDocumentListsEveryFunctionAndWhatIsLeftOut) {
    const std::string text = document();
    const std::size_t left_out = text.find("### Left out"), functions = text.find("## Functions");
    ASSERT_NE(left_out, std::string::npos);
    for (const TableRow& row : rows) {
        const std::string name = row.name, base = name.substr(0, name.size() - 1);
        const bool is_left = std::string(row.kind) == "left";
        const std::string part =
            is_left ? text.substr(left_out) : text.substr(functions, left_out - functions);
        EXPECT_TRUE(part.find("`" + name + "`") != std::string::npos ||
                    part.find("`" + base + "`\\*") != std::string::npos)
            << name;
    }
}

TEST(IrisGlTable, NoFunctionReplacesOneOfTheCLibrary) {
    for (const char* library : {"libc.so.6", "libm.so.6"}) {
        void* const handle = dlopen(library, RTLD_NOW);
        ASSERT_NE(handle, nullptr);
        for (const TableRow& row : rows) EXPECT_EQ(dlsym(handle, row.name), nullptr) << row.name;
        dlclose(handle);
    }
}

}  // namespace
