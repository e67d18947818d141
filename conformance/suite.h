// The conformance suite: recordings that reach the rules of docs/manual.md. docs/conformance.md.
// Does not play them: their manifests hold the expected results.
#pragma once

#include "conformance/groups.h"
#include "inspect/recording/recording.h"

#include <string>
#include <vector>

namespace gw::conformance {

/// The groups that have recordings, in the order of the manual's chapters.
const std::vector<Group>& groups();

struct Member {
    std::string name;
    inspect::Recording recording;
};
/// The recordings of a group: the same ones each time, on every machine. Throws Error if nearly all
/// cases of the group are too large for recordings.
std::vector<Member> members(const Group& group);

/// The rules of Group::rules, one by one: "R6.15", "R6.16", ...
std::vector<std::string> rules_of(const Group& group);

}  // namespace gw::conformance
