// The conformance suite is the same everywhere, and the reference machine gives what its manifests
// say. tests/conformance/digests.txt has, for each recording, XXH3-128 of its bytes and of its
// manifest; with GW_UPDATE=FILE the test writes FILE anew. Machines with gw/fast: tests/apps.
#include "conformance/suite.h"
#include "gw/error.h"
#include "gw/machine.h"
#include "inspect/manifest/manifest.h"
#include "inspect/recording/content.h"
#include "inspect/replay/forwarding_machine.h"
#include "inspect/replay/player.h"
#include "inspect/replay/shown_maps.h"
#include "test_paths.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cstdlib>
#include <fstream>

namespace gw::conformance {
namespace {

constexpr const char* digests_file = GW_SOURCE_DIR "/tests/conformance/digests.txt";

/// The manifest of a recording, played with a caller that rounds upwards [R1.2].
inspect::Manifest played(const inspect::Recording& recording) {
    const auto machine = make_reference(recording.profile, recording.width, recording.height);
    inspect::DigestingMachine digesting(*machine);
    std::fesetround(FE_UPWARD);
    inspect::ShownDigests shown(recording);
    inspect::play_by_pass(recording, digesting, [&](std::size_t) { shown.add(*machine); });
    std::fesetround(FE_TONEAREST);
    return inspect::manifest_of(recording, machine->passes(), shown.all());
}

std::string digest_of_text(const std::string& text) {
    return to_string(inspect::digest_of_bytes(
        {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
}

struct Digests {
    std::string recording, manifest;
};

std::map<std::string, Digests> expected_digests() {
    std::map<std::string, Digests> out;
    std::ifstream file(digests_file);
    std::string name;
    Digests d;
    while (file >> name >> d.recording >> d.manifest) out[name] = d;
    return out;
}

bool updates() { return std::getenv("GW_UPDATE") != nullptr; }

class ConformanceSuite : public testing::TestWithParam<Group> {
protected:
    static std::map<std::string, Digests>& written() {
        static std::map<std::string, Digests> all;
        return all;
    }
    static void TearDownTestSuite() {
        if (!updates()) return;
        std::ofstream file(std::getenv("GW_UPDATE"));
        for (const auto& [name, d] : written())
            file << name << " " << d.recording << " " << d.manifest << "\n";
    }
};

TEST_P(ConformanceSuite, TheReferenceMachineAgrees) {
    const auto expected = expected_digests();
    for (const Member& member : members(GetParam())) {
        const std::string manifest = digest_of_text(to_json(played(member.recording)));
        written()[member.name].manifest = manifest;
        if (updates()) continue;
        ASSERT_TRUE(expected.contains(member.name)) << member.name;
        ASSERT_EQ(manifest, expected.at(member.name).manifest) << member.name;
    }
}

TEST_P(ConformanceSuite, RecordingsAreTheSameOnEveryMachine) {
    const auto expected = expected_digests();
    for (const Member& member : members(GetParam())) {
        const std::string bytes = to_string(inspect::digest_of_bytes(encode(member.recording)));
        written()[member.name].recording = bytes;
        if (updates()) continue;
        ASSERT_TRUE(expected.contains(member.name)) << member.name;
        ASSERT_EQ(bytes, expected.at(member.name).recording) << member.name;
    }
}

/// What is shipped is what is made: decoded again it plays the same.
TEST_P(ConformanceSuite, RecordingsAreValid) {
    for (const Member& member : members(GetParam()))
        ASSERT_NO_THROW(inspect::decode(encode(member.recording))) << member.name;
}

TEST(ConformanceMembers, AGroupOfLargeCasesIsRefused) {
    const auto large = [](Random&) { return Case{vgx(), 60, 51, {}}; };
    try {
        members({"large", "", "", large, 2});
        FAIL() << "no error";
    } catch (const Error& e) {
        EXPECT_EQ(e.what(), std::string("group 'large': 0 of 2 recordings are small enough after "
                                        "2000 cases"));
    }
}

INSTANTIATE_TEST_SUITE_P(Group, ConformanceSuite, testing::ValuesIn(groups()),
                         [](const auto& tested) {
                             std::string name = tested.param.name;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace gw::conformance
