#include "apps/hidden/captions.h"

#include "apps/hidden/pictures.h"

#include <fmt/format.h>

namespace gw::apps {

namespace hs = hiddensurface;

namespace {

constexpr std::size_t most_polygons = 8;

TextLine subject_of(const hs::Step& step) {
    TextLine line{{hs::name_of(step.action)}};
    for (std::size_t i = 0; i < step.polygons.size() && i < most_polygons; ++i) {
        const bool in_order = step.action == hs::Action::Sort;
        line.push_back({std::to_string(step.polygons[i]), in_order || i == 0 ? white
                                                          : i == 1           ? yellow
                                                                             : grey});
    }
    if (step.polygons.size() > most_polygons) line.push_back({"...", grey});
    if (step.row >= 0) line.push_back({fmt::format("line {}", step.row), grey});
    return line;
}

TextLine question_of(const hs::Step& step) {
    if (step.result.empty()) return {{step.test, grey}};
    return {{step.test + ":", grey}, {step.result}};
}

}  // namespace

std::vector<TextLine> caption_of_step(const std::string& algorithm, const hs::Replay& replay) {
    const TextLine head{{algorithm},
                        {fmt::format("{} of {}", replay.position(), replay.size()), grey}};
    if (replay.position() == 0) return {head, {}, {}};
    const hs::Step& step = replay.step(replay.position() - 1);
    return {head, subject_of(step), question_of(step)};
}

std::array<std::vector<TextLine>, 3> captions_of(const std::string& algorithm,
                                                 const hs::Counts& counts) {
    const auto count = [](const char* name, std::uint64_t n) {
        return fmt::format("{} {}", n, name);
    };
    TextLine times;
    for (std::size_t i = 0; i < colors_of_counts.size(); ++i)
        times.push_back({std::to_string(i), i == 0 ? grey : colors_of_counts[i]});
    times.push_back({"or more", red});
    return {{{{{algorithm}}, {{count("splits", counts.splits), grey}}},
             {{{count("wrong", counts.wrong), counts.wrong > 0 ? red : white}},
              {{count("ties", counts.ties), yellow},
               {count("edges", counts.edges), cyan},
               {count("snapped", counts.snapped), blue}}},
             {{{"writes"}, {count("overdraw", counts.overdraw), grey}}, times}}};
}

}  // namespace gw::apps
