// The lab's session without a browser. Usage: gw_lab_door SCENE. Each line of standard input has
// the options of one picture as JSON; the answer, a line too, is the picture's manifest and what
// finishing the scene and drawing it warn of, or {"error": why}. A picture that is drawn again must
// have the same bits.
// gw_lab_door --ask METHOD OPTIONS prints the text that a method of the engine answers.
#include "gw/error.h"
#include "image/textures.h"
#include "web/engine/method.h"

#include <iostream>
#include <string>
#include <string_view>
#include <variant>

namespace {

using namespace gw;
using lab::Json;
using lab::LabSession;

/// A file's texels, as the page decodes them.
void add_picture(LabSession& session, const std::string& path) {
    const TextureLevel level = image::read_texture(path)->levels.front();
    const std::size_t row = 4 * std::size_t(level.width);
    std::string texels;  // from the top
    for (auto end = level.rgba.end(); end != level.rgba.begin(); end -= std::ptrdiff_t(row))
        texels.append(reinterpret_cast<const char*>(&*(end - std::ptrdiff_t(row))), 2 * row);
    session.add_picture(path, level.width, level.height, 16, texels);
}

/// As the page opens a scene. Returns what finishing it warns of.
Json opened(LabSession& session, const std::string& path) {
    const Json facts = session.open({{"path", path}});
    for (const Json& picture : facts.at("pictures")) add_picture(session, picture);
    return session.finish({}).at("warnings");
}

Json answer(LabSession& session, const Json& finished, const Json& options) {
    const Json manifest = Json::parse(session.manifest(options));
    const auto picture = session.picture();
    Json drawn;
    for (const char* time : {"first", "second"}) {
        drawn = session.draw(options);
        if (session.picture() != picture)
            return {{"error", std::string("draw() has other bits the ") + time + " time"}};
    }
    Json warnings = finished;
    for (const Json& line : drawn.at("warnings")) warnings.push_back(line);
    return {{"manifest", manifest}, {"warnings", warnings}};
}

}  // namespace

int main(int count, char** arguments) {
    if (count == 4 && arguments[1] == std::string_view("--ask")) {
        LabSession session;
        const auto found = lab::method_named(arguments[2]).body(session, Json::parse(arguments[3]));
        std::cout << std::get<std::string>(found);
        return 0;
    }
    if (count != 2) return 2;
    LabSession session;
    const Json finished = opened(session, arguments[1]);
    for (std::string line; std::getline(std::cin, line);) {
        try {
            std::cout << answer(session, finished, Json::parse(line)).dump() << std::endl;
        } catch (const std::exception& error) {
            std::cout << Json{{"error", error.what()}}.dump() << std::endl;
        }
    }
}
