#include "apps/study/hidden.h"

#include "apps/command/command.h"
#include "apps/command/folder_index.h"
#include "apps/command/page_style.h"
#include "apps/command/table.h"
#include "apps/command/terminal.h"
#include "apps/study/growth_plots.h"
#include "apps/study/prices.h"
#include "gw/error.h"
#include "image/output/output_set.h"
#include "image/plot/markup.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::apps {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// All price lists of the folder, by name: its TOML files but recipes.toml.
std::vector<study::PriceList> read_lists(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
        if (entry.path().extension() == ".toml" && entry.path().filename() != "recipes.toml")
            files.push_back(entry.path());
    if (error || files.empty())
        throw Error(folder.string() +
                    ": no price lists; expected a folder with recipes.toml and one or more lists");
    std::sort(files.begin(), files.end());
    std::vector<study::PriceList> lists;
    for (const auto& file : files) lists.push_back(study::read_prices(file));
    return lists;
}

/// A table of exponents: a row for each value, a column for each algorithm.
std::string exponents(const std::vector<study::GrowthLaw>& laws, const std::string& axis,
                      bool lines) {
    std::vector<std::string> algorithms;
    for (const study::GrowthLaw& law : laws)
        if (law.axis == axis && law.lines == lines &&
            std::count(algorithms.begin(), algorithms.end(), law.algorithm) == 0)
            algorithms.push_back(law.algorithm);
    if (algorithms.empty()) return "";
    Rows rows{{lines ? "lines: exponent of" : "exponent of"}};
    rows[0].insert(rows[0].end(), algorithms.begin(), algorithms.end());
    for (const std::string& value : study::growth_values(lines)) {
        std::vector<std::string> row{value};
        bool any = false;
        for (const std::string& name : algorithms) {
            const auto law = std::find_if(laws.begin(), laws.end(), [&](const study::GrowthLaw& l) {
                return l.axis == axis && l.lines == lines && l.algorithm == name &&
                       l.value == value;
            });
            any = any || law != laws.end();
            row.push_back(law == laws.end() ? "-" : fmt::format("{:.2f}", law->law.exponent));
        }
        if (any) rows.push_back(std::move(row));
    }
    return table(rows);
}

std::string exponents(const study::Growth& growth, const std::vector<study::GrowthLaw>& laws) {
    std::string text;
    for (const study::GrowthAxis& axis : study::growth_axes()) {
        if (std::none_of(laws.begin(), laws.end(),
                         [&](const study::GrowthLaw& l) { return l.axis == axis.name; }))
            continue;
        text += fmt::format("Against {}: value ~ {}^exponent\n", axis.label, axis.name);
        text += exponents(laws, axis.name, false) + exponents(laws, axis.name, true);
        for (const study::GrowthCut& cut : growth.cuts)
            if (cut.axis == axis.name)
                text += fmt::format(
                    "{} was stopped after {:.6g}, which took {:.2g} s: the next would take longer "
                    "than the limit\n",
                    cut.algorithm, cut.x, cut.seconds);
        text += "\n";
    }
    return text;
}

/// The three cheapest algorithms at each x, and every x at which two change places.
std::string ranking_text(const std::vector<study::Ranking>& rankings, const study::GrowthAxis& axis,
                         const study::PriceList& list, bool lines) {
    Rows rows{{axis.name, "cheapest", "second", "third"}};
    for (const study::Ranking& ranking : rankings) {
        std::vector<std::string> row{fmt::format("{:.4g}", ranking.x)};
        for (std::size_t i = 0; i < 3; ++i)
            row.push_back(i < ranking.algorithms.size()
                              ? fmt::format("{} {:.2e} s {:.2e} $", ranking.algorithms[i].first,
                                            ranking.algorithms[i].second.seconds,
                                            ranking.algorithms[i].second.dollars)
                              : "");
        rows.push_back(std::move(row));
    }
    std::string text =
        fmt::format("{} at prices of {} ({}), estimated:\n",
                    lines ? "Hidden lines" : "Hidden surfaces", list.name, list.machine) +
        table(rows);
    for (const study::Flip& flip : study::flips(rankings))
        text += fmt::format("from {} {:.3g} on {} is cheaper than {}\n", axis.name, flip.x,
                            flip.after, flip.before);
    return text + "\n";
}

class Sheet {
public:
    Sheet(const HiddenStudyOptions& options, image::OutputSet& output)
        : options_(options), output_(output) {}

    void add(const std::string& name, const std::string& heading, plot::Plot plot) {
        plot.command = options_.command;
        output_.add(options_.output / (name + ".svg")).write_text(plot::svg(plot));
        if (heading != heading_) page_ += "<h2>" + plot::escaped(heading) + "</h2>\n";
        heading_ = heading;
        page_ += fmt::format("<a href=\"{0}.svg\"><img src=\"{0}.svg\" alt=\"{1}\"></a>\n", name,
                             plot::escaped(plot.title));
    }
    void add_text(const std::string& heading, const std::string& text) {
        page_ +=
            "<h2>" + plot::escaped(heading) + "</h2>\n<pre>" + plot::escaped(text) + "</pre>\n";
    }
    void finish() {
        output_.add(options_.output / "index.html")
            .write_text(
                page_begin("Hidden surfaces: growth and cost") +
                "<style>img{width:min(100%,920px)}pre{white-space:pre;overflow-x:auto}</style>\n"
                "<p><a href=\"growth.csv\">growth.csv</a> <a href=\"laws.csv\">laws.csv</a> <a "
                "href=\"costs.csv\">costs.csv</a></p>\n" +
                page_ + std::string(page_end));
    }

private:
    const HiddenStudyOptions& options_;
    image::OutputSet& output_;
    std::string page_, heading_;
};

/// The rankings at every price list, as text and as CSV.
struct Costs {
    std::string text, csv = "prices,axis,x,rank,algorithm,seconds,dollars\n";
};

std::string cost_rows(const study::Ranking& ranking, const study::GrowthAxis& axis,
                      const study::PriceList& list) {
    std::string rows;
    for (std::size_t i = 0; i < ranking.algorithms.size(); ++i) {
        const auto& [algorithm, cost] = ranking.algorithms[i];
        rows += fmt::format("{},{},{},{},{},{},{}\n", list.name, axis.name, ranking.x, i + 1,
                            algorithm, cost.seconds, cost.dollars);
    }
    return rows;
}

Costs add_costs(const study::Growth& growth, const std::vector<study::PriceList>& lists,
                const study::Recipes& recipes, Sheet& sheet) {
    Costs costs;
    for (const study::PriceList& list : lists)
        for (const study::GrowthAxis& axis : study::growth_axes())
            for (const bool lines : {false, true}) {
                const auto rankings = study::rankings(growth, axis.name, lines, list, recipes);
                if (rankings.empty()) continue;
                costs.text += ranking_text(rankings, axis, list, lines);
                for (const study::Ranking& ranking : rankings)
                    costs.csv += cost_rows(ranking, axis, list);
                plot::Plot plot = study::cost_plot(rankings, axis, list, lines);
                study::add_styles(plot, growth, lines);
                sheet.add(fmt::format("{}cost_{}_{}", lines ? "lines_" : "", list.name, axis.name),
                          "Costs", std::move(plot));
            }
    return costs;
}

}  // namespace

int study_hidden(const HiddenStudyOptions& options, const Session& session) {
    const std::vector<study::PriceList> lists = read_lists(options.prices);
    const study::Recipes recipes = study::read_recipes(options.prices / "recipes.toml");
    image::OutputSet output;
    output.make_folder(options.output);
    Progress progress("measuring", options.quiet);
    const study::Growth growth = study::growth({options.limit, options.threads, options.axis, {}},
                                               [&](const std::string& what) { progress.at(what); });
    progress.at("writing");
    const auto laws = study::growth_laws(growth);
    Sheet sheet(options, output);
    const std::string growth_text = exponents(growth, laws);
    sheet.add_text("Exponents", growth_text);
    for (study::GrowthPlot& plot : study::growth_plots(growth))
        sheet.add(plot.name, "Against " + plot.axis, std::move(plot.plot));
    const Costs costs = add_costs(growth, lists, recipes, sheet);
    sheet.add_text("Rankings", costs.text);
    sheet.finish();
    output.add(options.output / "growth.csv").write_text(study::growth_csv(growth));
    output.add(options.output / "laws.csv").write_text(study::laws_csv(laws));
    output.add(options.output / "costs.csv").write_text(costs.csv);
    put_index(output, options.output, session);
    output.commit();
    print(growth_text + costs.text);
    return Done;
}

}  // namespace gw::apps
