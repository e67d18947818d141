#include "radiosity/solver/saved.h"

#include "gw/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <bit>
#include <cstdlib>

namespace gw::radiosity {
namespace {

/// Also of the form factors: going on must give the same bits.
constexpr const char* version = "5";

/// FNV-1a over 64-bit words, twice with different beginnings.
class Fingerprint {
public:
    void add(std::uint64_t v) {
        for (auto [state, odd] :
             {std::pair{&high_, 0x9e3779b97f4a7c15u}, std::pair{&low_, 0x100000001b3u}}) {
            *state = (*state ^ v) * odd;
            *state ^= *state >> 29;
        }
    }
    void add(double v) { add(std::bit_cast<std::uint64_t>(v)); }
    void add(float v) { add(std::uint64_t{std::bit_cast<std::uint32_t>(v)}); }
    void add(const dvec3& v) {
        for (int c = 0; c < 3; ++c) add(v[c]);
    }
    void add(const std::string& text) {
        add(std::uint64_t{text.size()});
        for (const char c : text) add(std::uint64_t{static_cast<unsigned char>(c)});
    }
    std::string text() const { return fmt::format("{:016x}{:016x}", high_, low_); }

private:
    std::uint64_t high_ = 0xcbf29ce484222325u, low_ = 0x84222325cbf29ce4u;
};

std::string text_of(const dvec3& v) {
    return fmt::format("{:016x} {:016x} {:016x}", std::bit_cast<std::uint64_t>(v.x),
                       std::bit_cast<std::uint64_t>(v.y), std::bit_cast<std::uint64_t>(v.z));
}

dvec3 vector_from(const std::string& text) {
    dvec3 v;
    const char* at = text.c_str();
    for (int c = 0; c < 3; ++c) {
        char* end = nullptr;
        v[c] = std::bit_cast<double>(std::uint64_t{std::strtoull(at, &end, 16)});
        at = end;
    }
    return v;
}

void put_split(std::vector<float>& values, double v) {
    const auto head = static_cast<float>(v);
    values.push_back(head);
    values.push_back(static_cast<float>(v - double(head)));
}

SavedPixmap pixmap_of(const PixmapModel& model, const Solution& solution,
                      const std::vector<dvec3>& E, const Pixmap& pixmap) {
    SavedPixmap out{pixmap.name, pixmap.width, pixmap.height, {}};
    for (std::size_t t = pixmap.first; t < pixmap.first + pixmap.count(); ++t) {
        const dvec3 B = E[t] + model.rho[t] * solution.H[t];
        for (int c = 0; c < 3; ++c) out.values.push_back(static_cast<float>(B[c]));
        for (int c = 0; c < 3; ++c) put_split(out.values, solution.H[t][c]);
        for (int c = 0; c < 3; ++c) put_split(out.values, solution.unshot[t][c]);
    }
    return out;
}

std::string contents(const std::vector<SavedPixmap>& pixmaps) {
    Fingerprint print;
    for (const SavedPixmap& pixmap : pixmaps)
        for (float v : pixmap.values) print.add(v);
    return print.text();
}

/// All names of figures and pixmaps, by a fingerprint; the first few to be read.
std::string objects(const PixmapModel& model) {
    constexpr std::size_t most = 8;
    Fingerprint print;
    std::vector<std::string> shown;
    for (const Figure& figure : model.figures) {
        print.add(figure.name);
        if (shown.size() <= most && (shown.empty() || shown.back() != figure.name))
            shown.push_back(figure.name);
    }
    for (const Pixmap& pixmap : model.pixmaps) print.add(pixmap.name);
    if (shown.size() > most) shown.back() = "...";
    return fmt::format("{} ({})", fmt::join(shown, ", "), print.text());
}

std::string fact(const Saved& saved, const char* name) {
    const auto found = saved.facts.find(name);
    return found == saved.facts.end() ? "" : found->second;
}

/// What of a fingerprint the command's options choose: "--hemicube 128 --parts 64 --seed 0".
std::string chosen(const std::string& method) {
    std::string text;
    for (const std::string name : {"hemicube", "parts", "seed"}) {
        const auto at = (" " + method).find(" " + name + " ");
        if (at == method.npos) continue;
        const auto value = at + name.size() + 1;
        text += (text.empty() ? "--" : " --") + name + " " +
                method.substr(value, method.find(' ', value) - value);
    }
    return text;
}

}  // namespace

const std::vector<std::string>& saved_channels() {
    static const std::vector<std::string> channels = [] {
        std::vector<std::string> all{"R", "G", "B"};
        for (const char* what : {"H", "unshot"})
            for (const char* color : {"R", "G", "B"})
                for (const char* part : {"head", "rest"})
                    all.push_back(fmt::format("{}.{}.{}", what, color, part));
        return all;
    }();
    return channels;
}

std::string fingerprint(const PixmapModel& model) {
    Fingerprint print;
    print.add(model.extent);
    for (const Pixmap& pixmap : model.pixmaps) {
        print.add(std::uint64_t(pixmap.width));
        print.add(std::uint64_t(pixmap.height));
    }
    for (const Facet& facet : model.facets) {
        print.add(std::uint64_t{facet.pixmap});
        for (const dvec3& v : {facet.origin, facet.du, facet.dv}) print.add(v);
    }
    for (std::size_t t = 0; t < model.texel_count(); ++t) {
        print.add(model.area[t]);
        print.add(model.rho[t]);
        print.add(model.E[t]);
    }
    for (const Patch& patch : model.patches) {
        print.add(std::uint64_t(patch.width));
        print.add(std::uint64_t(patch.height));
    }
    for (const DirectLight& light : model.direct) {
        print.add(light.name);
        print.add(light.emitted);
        for (const dvec3& H : light.H) print.add(H);
    }
    return print.text();
}

std::string fingerprint(const FormFactorOptions& options) {
    return fmt::format("hemicube {} {} parts {} nearness {} smallest {} {} emitter {} seed {}",
                       options.hemicube, options.scan.texels ? "by texels" : "by pixels",
                       options.scan.most_parts, options.points.nearness,
                       options.points.smallest_part, options.points.smallest_of_pixmap,
                       options.points.emitter_part, options.seed);
}

Saved save(const PixmapModel& model, const FormFactorOptions& options, const Solution& solution) {
    return save(model, options, solution, model.E);
}

Saved save(const PixmapModel& model, const FormFactorOptions& options, const Solution& solution,
           const std::vector<dvec3>& E) {
    Saved saved;
    for (const Pixmap& pixmap : model.pixmaps)
        saved.pixmaps.push_back(pixmap_of(model, solution, E, pixmap));
    saved.facts = {{"kind", whole_kind},
                   {"version", version},
                   {"scene", model.drawn.name},
                   {"model", fingerprint(model)},
                   {"objects", objects(model)},
                   {"method", fingerprint(options)},
                   {"shots", std::to_string(solution.shots)},
                   {"escaped", text_of(solution.escaped)},
                   {"backs", text_of(solution.backs)},
                   {"contents", contents(saved.pixmaps)}};
    return saved;
}

void check_saved(const Saved& saved, const PixmapModel& model, const FormFactorOptions& options,
                 const std::string& file, const char* kind) {
    const auto expect = [&](const char* name, const std::string& wanted, const std::string& what) {
        if (fact(saved, name) == wanted) return;
        throw Error(file, 0, fmt::format("{}; expected {}", what, wanted));
    };
    expect("kind", kind, fmt::format("holds '{}'", fact(saved, "kind")));
    expect("version", version,
           fmt::format("was saved in version '{}' of the format", fact(saved, "version")));
    if (fact(saved, "model") != fingerprint(model))
        throw Error(file, 0,
                    fmt::format("was computed for scene '{}' as it was then; expected one of '{}' "
                                "with the same figures, materials and pixmaps",
                                fact(saved, "scene"), model.drawn.name));
    if (saved.facts.contains("objects"))  // older files have none
        expect("objects", objects(model),
               fmt::format("was computed for objects named {}", fact(saved, "objects")));
    const std::string method = fact(saved, "method"), wanted = fingerprint(options);
    if (method == wanted) return;
    if (chosen(method) == chosen(wanted))
        throw Error(file, 0, "was computed by another version of gw; expected one of this version");
    throw Error(file, 0,
                fmt::format("was computed with {}; expected {}", chosen(method), chosen(wanted)));
}

Solution load(const Saved& saved, const PixmapModel& model, const FormFactorOptions& options,
              const std::string& file, const char* kind) {
    check_saved(saved, model, options, file, kind);
    const auto damaged = [&](const char* what) {
        return Error(file, 0, fmt::format("is damaged: {}; expected it as it was saved", what));
    };
    if (saved.pixmaps.size() != model.pixmaps.size()) throw damaged("pixmaps are missing");
    if (contents(saved.pixmaps) != fact(saved, "contents"))
        throw damaged("its values have another checksum");
    Solution solution = initial_solution(model);
    solution.shots = std::strtoull(fact(saved, "shots").c_str(), nullptr, 10);
    solution.escaped = vector_from(fact(saved, "escaped"));
    solution.backs = vector_from(fact(saved, "backs"));
    const std::size_t stride = saved_channels().size();
    for (std::size_t i = 0; i < model.pixmaps.size(); ++i) {
        const Pixmap& pixmap = model.pixmaps[i];
        const std::vector<float>& values = saved.pixmaps[i].values;
        if (values.size() != pixmap.count() * stride) throw damaged("a pixmap has another size");
        for (std::size_t t = 0; t < pixmap.count(); ++t)
            for (int c = 0; c < 3; ++c) {
                const float* at = &values[t * stride + 3 + 2 * std::size_t(c)];
                solution.H[pixmap.first + t][c] = double(at[0]) + double(at[1]);
                solution.unshot[pixmap.first + t][c] = double(at[6]) + double(at[7]);
            }
    }
    return solution;
}

}  // namespace gw::radiosity
