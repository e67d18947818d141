// The engine's door to JavaScript (Embind). A method answers text; a refusal is {"error": why}.
#include "gw/error.h"
#include "hiddensurface/interface/line_algorithm.h"
#include "web/engine/lab_session.h"

#include <emscripten/bind.h>

namespace gw::lab {
namespace {

template <class Answer>
std::string answered(const Answer& answer) {
    try {
        if constexpr (std::is_same_v<decltype(answer()), std::string>)
            return answer();
        else
            return answer().dump();
    } catch (const std::bad_alloc&) {
        return Json{{"error", "not enough memory; expected a smaller scene or picture"}}.dump();
    } catch (const std::exception& error) {
        return Json{{"error", error.what()}}.dump(-1, ' ', false, Json::error_handler_t::replace);
    }
}

class Engine {
public:
    std::string add_picture(const std::string& path, int width, int height, int bits,
                            const std::string& texels) {
        return answered([&] {
            session_.add_picture(path, width, height, bits, texels);
            return Json::object();
        });
    }
    std::string open(const std::string& path) {
        return answered([&] { return session_.open(path); });
    }
    /// A method of the session from options to an answer.
    template <auto method>
    std::string call(const std::string& options) {
        return answered([&] { return (session_.*method)(Json::parse(options)); });
    }
    std::string play(const std::string& options, const std::string& steps) {
        return answered([&] { return session_.play(Json::parse(options), steps); });
    }
    /// A view of the engine's memory, until the next call.
    emscripten::val picture() const { return view_of(session_.picture()); }
    emscripten::val change() const { return view_of(session_.change()); }
    emscripten::val difference() const { return view_of(session_.difference()); }

private:
    static emscripten::val view_of(const std::vector<std::uint8_t>& bytes) {
        return emscripten::val(emscripten::typed_memory_view(bytes.size(), bytes.data()));
    }
    LabSession session_;
};

/// [{"name", "title", "lines"}]
std::string algorithms() {
    Json all = Json::array();
    for (const hiddensurface::Algorithm& a : hiddensurface::algorithms())
        all.push_back({{"name", a.name}, {"title", a.title}, {"lines", false}});
    for (const hiddensurface::LineAlgorithm& a : hiddensurface::line_algorithms())
        all.push_back({{"name", a.name}, {"title", a.title}, {"lines", true}});
    return all.dump();
}

}  // namespace
}  // namespace gw::lab

EMSCRIPTEN_BINDINGS(gw) {
    using gw::lab::Engine;
    using gw::lab::LabSession;
    emscripten::class_<Engine>("Engine")
        .constructor<>()
        .function("add_picture", &Engine::add_picture)
        .function("open", &Engine::open)
        .function("draw", &Engine::call<&LabSession::draw>)
        .function("manifest", &Engine::call<&LabSession::manifest>)
        .function("hidden", &Engine::call<&LabSession::hidden>)
        .function("passes", &Engine::call<&LabSession::passes>)
        .function("plane", &Engine::call<&LabSession::plane>)
        .function("history", &Engine::call<&LabSession::history>)
        .function("pixel", &Engine::call<&LabSession::pixel>)
        .function("volumes", &Engine::call<&LabSession::volumes>)
        .function("polygons", &Engine::call<&LabSession::polygons>)
        .function("light", &Engine::call<&LabSession::light>)
        .function("lit", &Engine::call<&LabSession::lit>)
        .function("pixmap", &Engine::call<&LabSession::pixmap>)
        .function("hemicube", &Engine::call<&LabSession::hemicube>)
        .function("rays", &Engine::call<&LabSession::rays>)
        .function("raytraced", &Engine::call<&LabSession::raytraced>)
        .function("identifiers", &Engine::call<&LabSession::identifiers>)
        .function("reasons", &Engine::call<&LabSession::reasons>)
        .function("path", &Engine::call<&LabSession::path>)
        .function("outside", &Engine::call<&LabSession::outside>)
        .function("cast", &Engine::call<&LabSession::cast>)
        .function("visits", &Engine::call<&LabSession::visits>)
        .function("inside", &Engine::call<&LabSession::inside>)
        .function("play", &Engine::play)
        .function("picture", &Engine::picture)
        .function("change", &Engine::change)
        .function("difference", &Engine::difference);
    emscripten::function("algorithms", &gw::lab::algorithms);
    emscripten::function("simd_target", &gw::simd_target);
}
