// The lab's session without a browser. Usage: gw_lab_door SCENE. Each line of standard input has
// the options of one picture as JSON; the answer, a line too, is the picture's manifest and
// warnings, or {"error": why}. A picture that is drawn again must have the same bits.
// gw_lab_door --ask METHOD OPTIONS prints the text that a method of the engine answers.
#include "gw/error.h"
#include "web/engine/method.h"

#include <iostream>
#include <string>
#include <string_view>
#include <variant>

namespace {

using gw::lab::Json;
using gw::lab::LabSession;

Json answer(LabSession& session, const Json& options) {
    const Json manifest = Json::parse(session.manifest(options));
    const auto picture = session.picture();
    Json drawn;
    for (const char* time : {"first", "second"}) {
        drawn = session.draw(options);
        if (session.picture() != picture)
            return {{"error", std::string("draw() has other bits the ") + time + " time"}};
    }
    return {{"manifest", manifest}, {"warnings", drawn.at("warnings")}};
}

}  // namespace

int main(int count, char** arguments) {
    if (count == 4 && arguments[1] == std::string_view("--ask")) {
        LabSession session;
        const auto found =
            gw::lab::method_named(arguments[2]).body(session, Json::parse(arguments[3]));
        std::cout << std::get<std::string>(found);
        return 0;
    }
    if (count != 2) return 2;
    LabSession session;
    session.open({{"path", arguments[1]}});
    for (std::string line; std::getline(std::cin, line);) {
        try {
            std::cout << answer(session, Json::parse(line)).dump() << std::endl;
        } catch (const std::exception& error) {
            std::cout << Json{{"error", error.what()}}.dump() << std::endl;
        }
    }
}
