#include "image/plot/markup.h"

#include <array>
#include <utility>

namespace gw::plot {
namespace {

constexpr std::array<std::pair<char, std::string_view>, 5> entities{
    {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}}};

}  // namespace

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        out += c;
        for (const auto& [character, entity] : entities)
            if (c == character) out.replace(out.size() - 1, 1, entity);
    }
    return out;
}

}  // namespace gw::plot
