// The engine's door to JavaScript (Embind): the table of methods, by name.
#include "gw/error.h"
#include "web/engine/method.h"

#include <emscripten/bind.h>

namespace gw::lab {
namespace {

using emscripten::val;

/// A copy: the session's bytes move when it draws again.
val copied(const std::vector<std::uint8_t>& bytes) {
    return val(emscripten::typed_memory_view(bytes.size(), bytes.data())).call<val>("slice");
}

val refusal(const std::string& why) {
    val answer = val::object();
    answer.set("error", why);
    return answer;
}

/// What the call answers; a refusal is {error}.
template <class Call>
val answered(const Call& call) {
    try {
        return call();
    } catch (const std::bad_alloc&) {
        return refusal("not enough memory; expected a smaller scene or picture");
    } catch (const std::exception& error) {
        return refusal(error.what());
    }
}

class Engine {
public:
    val add_picture(const std::string& path, int width, int height, int bits,
                    const std::string& texels) {
        return answered([&] {
            session_.add_picture(path, width, height, bits, texels);
            return val::object();
        });
    }
    /// {json} or {text}, and the planes of the method's row.
    val call(const std::string& name, const std::string& options) {
        return answered([&] {
            const Method& method = method_named(name);
            const Method::Answer found = method.body(session_, Json::parse(options));
            val answer = val::object();
            if (const auto* text = std::get_if<std::string>(&found))
                answer.set("text", *text);
            else
                answer.set("json", std::get<Json>(found).dump());
            for (const Method::Plane& plane : method.planes)
                answer.set(plane.name, copied((session_.*plane.bytes)()));
            return answer;
        });
    }

private:
    LabSession session_;
};

}  // namespace
}  // namespace gw::lab

EMSCRIPTEN_BINDINGS(gw) {
    using gw::lab::Engine;
    emscripten::class_<Engine>("Engine")
        .constructor<>()
        .function("add_picture", &Engine::add_picture)
        .function("call", &Engine::call);
}
