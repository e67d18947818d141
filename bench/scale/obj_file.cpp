#include "bench/scale/obj_file.h"

#include "gw/error.h"
#include "gw/mesh.h"
#include "scene/obj/read_obj.h"

#include <fmt/format.h>

#ifdef GW_WITH_TINYOBJ
#include <tiny_obj_loader.h>
#endif

#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>

namespace gw::bench {
namespace {

double height(double x, double z) {
    return 0.3 * std::sin(3 * x) * std::cos(2 * z) + 0.02 * std::sin(40 * x + 7 * z);
}

/// Rows of text to a file, a megabyte at a time.
class Text {
public:
    explicit Text(const std::filesystem::path& path)
        : path_(path), file_(std::fopen(path.c_str(), "wb"), std::fclose) {
        if (!file_) throw Error(path.string(), 0, "cannot be written");
    }
    template <class... Values>
    void add(fmt::format_string<Values...> form, Values&&... values) {
        fmt::format_to(std::back_inserter(text_), form, std::forward<Values>(values)...);
        if (text_.size() > 1 << 20) flush();
    }
    void flush() {
        if (std::fwrite(text_.data(), 1, text_.size(), file_.get()) != text_.size() ||
            std::fflush(file_.get()) != 0)
            throw Error(path_.string(), 0, "cannot be written");
        text_.clear();
    }

private:
    std::filesystem::path path_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    fmt::memory_buffer text_;
};

double seconds(const auto& work) {
    const std::clock_t begin = std::clock();
    work();
    return double(std::clock() - begin) / CLOCKS_PER_SEC;
}

}  // namespace

std::size_t write_sheet(const std::filesystem::path& path, double triangles, bool full) {
    const auto n = std::size_t(std::max(1.0, std::round(std::sqrt(triangles / 2))));
    const auto at = [n](std::size_t i) { return 10.0 * double(i) / double(n) - 5; };
    Text text(path);
    for (std::size_t j = 0; j <= n; ++j)
        for (std::size_t i = 0; i <= n; ++i)
            text.add("v {:.6f} {:.6f} {:.6f}\n", at(i), height(at(i), at(j)), at(j));
    for (std::size_t j = 0; full && j <= n; ++j)
        for (std::size_t i = 0; i <= n; ++i) {
            const double step = 1e-3, x = at(i), z = at(j), y = height(x, z);
            text.add("vt {:.6f} {:.6f}\nvn {:.4f} 1 {:.4f}\n", double(i) / double(n),
                     double(j) / double(n), (y - height(x + step, z)) / step,
                     (y - height(x, z + step)) / step);
        }
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t a = j * (n + 1) + i + 1, b = a + 1, c = a + n + 1, d = c + 1;
            if (full)
                text.add(
                    "f {0}/{0}/{0} {2}/{2}/{2} {1}/{1}/{1}\nf {1}/{1}/{1} {2}/{2}/{2} {3}/{3}/{3}\n",
                    a, b, c, d);
            else
                text.add("f {0} {2} {1}\nf {1} {2} {3}\n", a, b, c, d);
        }
    text.flush();
    return 2 * n * n;
}

double read_ours(const std::filesystem::path& path) {
    return seconds([&] {
        scene::Warnings warnings;
        scene::ObjFile file = scene::read_obj(path, {}, warnings);
        for (scene::ObjPart& part : file.parts) make_mesh(std::move(part.mesh));
    });
}

double read_tinyobj([[maybe_unused]] const std::filesystem::path& path) {
#ifdef GW_WITH_TINYOBJ
    return seconds([&] {
        tinyobj::attrib_t attributes;
        std::vector<tinyobj::shape_t> shapes;
        std::vector<tinyobj::material_t> materials;
        std::string warning, error;
        if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, path.c_str()))
            throw Error(path.string(), 0, "tinyobjloader: " + error);
    });
#else
    return 0;
#endif
}

}  // namespace gw::bench
