#include "apps/command/page_style.h"

#include "image/plot/markup.h"

#include <fmt/format.h>

namespace gw::apps {
namespace {

/// What only these pages have: text from side to side, tables of numbers, pictures side by side.
constexpr std::string_view own_style = R"(
body { max-width: 84em; overflow-wrap: anywhere }
table { border-collapse: collapse }
th, td { border-bottom: 1px solid var(--line); padding: .25em .8em; text-align: left; overflow-wrap: normal }
.wide { margin-bottom: 1em }
.n { text-align: right; font-variant-numeric: tabular-nums }
.wide, main > table { display: block; max-width: 100%; overflow-x: auto }
section { margin-top: 2.5em; border-top: 1px solid var(--line) }
h2 small { font-weight: normal; color: var(--faint) }
pre { white-space: pre-wrap; font-size: var(--small) }
img { max-width: 100%; background: #fff }
)";

/// The colours of page.css are chosen by an attribute.
constexpr std::string_view theme = R"(<script id="theme">
const dark = matchMedia('(prefers-color-scheme: dark)')
const follow = () => (document.documentElement.dataset.theme = dark.matches ? 'dark' : 'light')
dark.addEventListener('change', follow)
follow()
</script>
)";

}  // namespace

std::string page_begin(std::string_view title, std::string_view head, std::string_view language) {
    const std::string text = plot::escaped(title);
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"{}\"><meta charset=\"utf-8\">{}\n<meta name=\"viewport\" "
        "content=\"width=device-width\">\n<title>{}</title>\n<style>\n{}{}</style>\n{}<main>\n<h1>{}"
        "</h1>\n",
        language, head, text, embedded_style("page.css"), own_style, theme, text);
}

}  // namespace gw::apps
