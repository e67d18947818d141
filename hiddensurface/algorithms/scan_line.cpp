// The scan-line algorithm [L6]: draws its visible spans. Beside the edge table it remembers one
// line.
#include "hiddensurface/faces/visible_spans.h"

namespace gw::hiddensurface {
namespace {

Output run(const Input& input, StepLog& log) {
    Output output{.list = begin_picture(input, "scan-line")};
    log.watch(watched(output.counts));
    for_visible_spans(input, output.counts, log, [&](const std::vector<VisibleSpan>& line) {
        std::vector<Painted> painted;
        for (const VisibleSpan& span : line)
            add_run(painted, span.run, input.polygons[span.polygon].id);
        if (!line.empty()) draw_line(input, line.front().run.y, std::move(painted), output, log);
    });
    return output;
}

}  // namespace

Algorithm scan_line() {
    return {.name = "scan-line",
            .title = "Scan-line: edges, segments sorted in x, sample spans [L6]",
            .claim = Claim::Always,
            .run = run};
}

}  // namespace gw::hiddensurface
