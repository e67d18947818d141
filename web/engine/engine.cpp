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
    /// A method of the bench from options to an answer.
    template <auto method>
    std::string call(const std::string& options) {
        return answered([&] { return (bench_.*method)(Json::parse(options)); });
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
    using gw::lab::Bench;
    using gw::lab::Engine;
    emscripten::class_<Engine>("Engine")
        .constructor<>()
        .function("add_picture", &Engine::add_picture)
        .function("open", &Engine::open)
        .function("draw", &Engine::call<&Bench::draw>)
        .function("manifest", &Engine::call<&Bench::manifest>)
        .function("hidden", &Engine::call<&Bench::hidden>)
        .function("passes", &Engine::call<&Bench::passes>)
        .function("plane", &Engine::call<&Bench::plane>)
        .function("history", &Engine::call<&Bench::history>)
        .function("pixel", &Engine::call<&Bench::pixel>)
        .function("volumes", &Engine::call<&Bench::volumes>)
        .function("polygons", &Engine::call<&Bench::polygons>)
        .function("light", &Engine::call<&Bench::light>)
        .function("lit", &Engine::call<&Bench::lit>)
        .function("pixmap", &Engine::call<&Bench::pixmap>)
        .function("hemicube", &Engine::call<&Bench::hemicube>)
        .function("rays", &Engine::call<&Bench::rays>)
        .function("raytraced", &Engine::call<&Bench::raytraced>)
        .function("identifiers", &Engine::call<&Bench::identifiers>)
        .function("reasons", &Engine::call<&Bench::reasons>)
        .function("path", &Engine::call<&Bench::path>)
        .function("outside", &Engine::call<&Bench::outside>)
        .function("cast", &Engine::call<&Bench::cast>)
        .function("visits", &Engine::call<&Bench::visits>)
        .function("inside", &Engine::call<&Bench::inside>)
        .function("play", &Engine::play)
        .function("picture", &Engine::picture)
        .function("change", &Engine::change)
        .function("difference", &Engine::difference);
    emscripten::function("algorithms", &gw::lab::algorithms);
    emscripten::function("simd_target", &gw::simd_target);
}
