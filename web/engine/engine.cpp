// The engine's door to JavaScript (Embind). A method answers text; a refusal is {"error": why}.
#include "gw/error.h"
#include "hiddensurface/lines/line_algorithm.h"
#include "web/engine/bench.h"

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
            bench_.add_picture(path, width, height, bits, texels);
            return Json::object();
        });
    }
    std::string open(const std::string& path) {
        return answered([&] { return bench_.open(path); });
    }
    std::string draw(const std::string& options) {
        return answered([&] { return bench_.draw(Json::parse(options)); });
    }
    std::string manifest(const std::string& options) {
        return answered([&] { return bench_.manifest(Json::parse(options)); });
    }
    std::string hidden(const std::string& options) {
        return answered([&] { return bench_.hidden(Json::parse(options)); });
    }
    std::string passes(const std::string& options) {
        return answered([&] { return bench_.passes(Json::parse(options)); });
    }
    std::string plane(const std::string& options) {
        return answered([&] { return bench_.plane(Json::parse(options)); });
    }
    std::string history(const std::string& options) {
        return answered([&] { return bench_.history(Json::parse(options)); });
    }
    std::string pixel(const std::string& options) {
        return answered([&] { return bench_.pixel(Json::parse(options)); });
    }
    std::string volumes(const std::string& options) {
        return answered([&] { return bench_.volumes(Json::parse(options)); });
    }
    std::string polygons(const std::string& options) {
        return answered([&] { return bench_.polygons(Json::parse(options)); });
    }
    std::string light(const std::string& options) {
        return answered([&] { return bench_.light(Json::parse(options)); });
    }
    std::string lit(const std::string& options) {
        return answered([&] { return bench_.lit(Json::parse(options)); });
    }
    std::string pixmap(const std::string& options) {
        return answered([&] { return bench_.pixmap(Json::parse(options)); });
    }
    std::string hemicube(const std::string& options) {
        return answered([&] { return bench_.hemicube(Json::parse(options)); });
    }
    std::string play(const std::string& options, const std::string& steps) {
        return answered([&] { return bench_.play(Json::parse(options), steps); });
    }
    /// A view of the engine's memory, until the next call.
    emscripten::val picture() const { return view_of(bench_.picture()); }
    emscripten::val change() const { return view_of(bench_.change()); }
    emscripten::val difference() const { return view_of(bench_.difference()); }

private:
    static emscripten::val view_of(const std::vector<std::uint8_t>& bytes) {
        return emscripten::val(emscripten::typed_memory_view(bytes.size(), bytes.data()));
    }
    Bench bench_;
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
    emscripten::class_<Engine>("Engine")
        .constructor<>()
        .function("add_picture", &Engine::add_picture)
        .function("open", &Engine::open)
        .function("draw", &Engine::draw)
        .function("manifest", &Engine::manifest)
        .function("hidden", &Engine::hidden)
        .function("passes", &Engine::passes)
        .function("plane", &Engine::plane)
        .function("history", &Engine::history)
        .function("pixel", &Engine::pixel)
        .function("volumes", &Engine::volumes)
        .function("polygons", &Engine::polygons)
        .function("light", &Engine::light)
        .function("lit", &Engine::lit)
        .function("pixmap", &Engine::pixmap)
        .function("hemicube", &Engine::hemicube)
        .function("play", &Engine::play)
        .function("picture", &Engine::picture)
        .function("change", &Engine::change)
        .function("difference", &Engine::difference);
    emscripten::function("algorithms", &gw::lab::algorithms);
    emscripten::function("simd_target", &gw::simd_target);
}
