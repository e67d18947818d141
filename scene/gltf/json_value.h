// A JSON text as values that know their file and their place in it, "meshes[0].primitives[1].mode".
// Readers use nlohmann's library only through it. Does not know any key.
#pragma once

#include "scene/validate/limits.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gw::scene {

using Json = nlohmann::json;

/// Copies share the text. Every member that reads throws Error "FILE: PLACE is WHAT; expected WHAT"
/// if the value is of another kind.
class JsonValue {
public:
    /// `file` stands for the text in messages. Throws Error if the text is not JSON.
    static JsonValue read(const std::string& file, std::string_view text);

    const std::string& file() const { return *file_; }
    const std::string& place() const { return place_; }

    /// The value of an object's key, if there is one.
    std::optional<JsonValue> find(const std::string& key) const;
    JsonValue at(const std::string& key) const;  ///< a key that must be there
    /// The keys of an object.
    std::vector<std::string> keys() const;
    /// The elements of an array.
    std::size_t size() const;
    JsonValue operator[](std::size_t i) const;

    double number(Range range = {}) const;
    std::size_t whole(std::size_t least, std::size_t most) const;
    bool boolean() const;
    const std::string& text() const;

    [[noreturn]] void fail(std::string_view what) const;
    [[noreturn]] void fail_expected(std::string_view expected) const;

private:
    JsonValue(std::shared_ptr<const Json> whole, std::shared_ptr<const std::string> file)
        : whole_(std::move(whole)), file_(std::move(file)), json_(whole_.get()) {}
    JsonValue inner(const Json& json, std::string place) const;

    std::shared_ptr<const Json> whole_;
    std::shared_ptr<const std::string> file_;
    const Json* json_ = nullptr;
    std::string place_;
};

}  // namespace gw::scene
