#include "gw/error.h"
#include "inspect/peer/surface.h"

#include <GL/osmesa.h>
#include <fmt/format.h>

#include <vector>

namespace gw::peer {
namespace {

class OsmesaSurface : public Surface {
public:
    OsmesaSurface(const Loaded& loaded, int width, int height)
        : functions_(loaded.functions()),
          width_(width),
          height_(height),
          buffer_(std::size_t{4} * std::size_t(width) * std::size_t(height)) {
        decltype(&OSMesaCreateContextExt) create = nullptr;
        loaded.get("OSMesaCreateContextExt", create);
        loaded.get("OSMesaDestroyContext", destroy_);
        loaded.get("OSMesaMakeCurrent", make_current_);
        context_.reset(create(OSMESA_RGBA, 24, 8, 16, nullptr));
        if (!context_) throw Error(loaded.path() + " makes no context of OSMesa");
        make_current();
        loaded.complete(functions_);
    }

    void make_current() override {
        if (!make_current_(context_.get(), buffer_.data(), GL_UNSIGNED_BYTE, width_, height_))
            throw Error(fmt::format("OSMesa refuses a window of {}x{}", width_, height_));
        use(functions_);
    }

private:
    struct Destroy {
        const OsmesaSurface* surface;
        void operator()(OSMesaContext context) const { surface->destroy_(context); }
    };

    Functions functions_;
    decltype(&OSMesaDestroyContext) destroy_ = nullptr;
    decltype(&OSMesaMakeCurrent) make_current_ = nullptr;
    int width_, height_;
    std::vector<GLubyte> buffer_;  ///< the colour plane
    std::unique_ptr<osmesa_context, Destroy> context_{nullptr, Destroy{this}};
};

}  // namespace

std::unique_ptr<Surface> make_osmesa(const Loaded& loaded, int width, int height) {
    return std::make_unique<OsmesaSurface>(loaded, width, height);
}

}  // namespace gw::peer
