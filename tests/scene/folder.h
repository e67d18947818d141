// A temporary folder with small files, and the messages of reading them. Removed at the end of the
// test.
#pragma once

#include "gw/error.h"
#include "scene/obj/read_obj.h"
#include "scene/toml/read_scene.h"

#include "tests/temporary_folder.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gw::scene {

class Folder : public TemporaryFolder {
public:
    /// A text without this folder's name, so that tests can state messages in full.
    std::string relative(std::string text) const {
        const std::string prefix = path().string() + "/";
        for (auto at = text.find(prefix); at != text.npos; at = text.find(prefix))
            text.erase(at, prefix.size());
        return text;
    }

    /// The message of the Error that `action` throws; "no error" if it throws none.
    template <typename Action>
    std::string error(const Action& action) const {
        try {
            action();
        } catch (const Error& caught) {
            return relative(caught.what());
        }
        return "no error";
    }
    std::string scene_error(const std::string& name, const std::string& text) const {
        const auto file = write(name, text);
        return error([&] { read_scene(file); });
    }

    ObjFile obj(const std::string& text, const ObjOptions& options = {}) {
        const auto file = write("m.obj", text);
        warnings_ = Warnings();
        return read_obj(file, options, warnings_);
    }
    std::string obj_error(const std::string& text) {
        return error([&] { obj(text); });
    }
    std::vector<std::string> warnings() const {
        std::vector<std::string> lines;
        for (const std::string& line : warnings_.lines()) lines.push_back(relative(line));
        return lines;
    }
    Warnings& warnings_list() { return warnings_; }

private:
    Warnings warnings_;
};

/// Three positions on lines 1 to 3.
inline const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

using Strings = std::vector<std::string>;

}  // namespace gw::scene
