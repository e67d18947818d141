#include "web/engine/method.h"

#include "gw/error.h"

#include <map>
#include <utility>

namespace gw::lab {
namespace {

std::map<std::string, const Method*>& table() {
    static std::map<std::string, const Method*> rows;
    return rows;
}

}  // namespace

Method::Method(std::string name_, Body body_, std::vector<Plane> planes_)
    : name(std::move(name_)), body(std::move(body_)), planes(std::move(planes_)) {
    table()[name] = this;
}

const Method& method_named(const std::string& name) {
    const auto found = table().find(name);
    if (found == table().end()) throw Error("the engine has no method '" + name + "'");
    return *found->second;
}

}  // namespace gw::lab
