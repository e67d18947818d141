// The lab's session without a browser. Usage: gw_lab_door SCENE. Each line of standard input has
// the options of one picture as JSON; the answer, a line too, is the picture's manifest and
// warnings, or {"error": why}. A picture that is drawn again must have the same bits.
#include "gw/error.h"
#include "web/engine/lab_session.h"

#include <iostream>
#include <string>

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
