// gw radiosity: solves, saves, shows and changes pixmaps [F].
#include "apps/command/command.h"
#include "apps/command/command_recorder.h"
#include "apps/command/early_end.h"
#include "apps/command/folder_index.h"
#include "apps/command/terminal.h"
#include "apps/picture/picture_options.h"
#include "apps/radiosity/files.h"
#include "apps/radiosity/light_maps.h"
#include "apps/radiosity/lux.h"
#include "apps/radiosity/mix.h"
#include "apps/radiosity/options.h"
#include "apps/radiosity/pictures.h"
#include "inspect/text/plural.h"
#include "radiosity/solver/stall.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>

namespace gw::apps {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double seconds_between_saves = 5;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// The mean difference of two solutions of the same figures, over all channels, as a share of the
/// mean radiosity.
double mean_difference(const radiosity::Solver& a, const radiosity::Solver& b) {
    double off = 0, sum = 0;
    for (std::size_t t = 0; t < a.model().texel_count(); ++t) {
        const dvec3 B = radiosity::radiosity_at(b.model(), b.solution(), t),
                    d = radiosity::radiosity_at(a.model(), a.solution(), t) - B;
        off += b.model().area[t] * (std::abs(d.x) + std::abs(d.y) + std::abs(d.z));
        sum += b.model().area[t] * (B.x + B.y + B.z);
    }
    return sum > 0 ? off / sum : 0;
}

std::filesystem::path recording_file(const RadiosityOptions& options, const std::string& name) {
    return options.output / (name + ".gwt");
}

/// Writes the recordings of the hemicubes and of the pictures; hemicubes_2 ... for further machines.
void put_recordings(CommandRecorder& recorder, const RadiosityOptions& options,
                    const Session& session) {
    image::OutputSet files(session.inputs);
    std::map<std::string, int> counts;
    for (const inspect::Recording& r : recorder.take(options.picture.scene.string(), "radiosity")) {
        const std::string kind = r.profile == radiosity::id_profile() ? "hemicubes" : "pictures";
        const int number = ++counts[kind];
        files.add(recording_file(options, number > 1 ? fmt::format("{}_{}", kind, number) : kind))
            .write(inspect::encode(r));
    }
    files.commit();
}

void apply_changes(const std::vector<Change>& changes, scene::Scene& scene) {
    try {
        for (const Change& change : changes) apply(change, scene);
    } catch (const Error& error) {
        throw UsageError(std::string("--change: ") + error.what());
    }
}

class Run {
public:
    Run(const RadiosityOptions& options, Session& session, const scene::Scene& scene,
        radiosity::PixmapModel model, Progress& progress)
        : options_(options),
          session_(session),
          progress_(progress),
          scene_(scene),
          solver_(std::move(model), options.solver),
          stall_(solver_.model().patches.size()) {}

    int run() {
        image::OutputSet folder;
        if (writes_) folder.make_folder(options_.output);
        if (writes_) image::check_target(saved_file());
        scene::Scene changed = scene_;
        apply_changes(options_.changes, changed);
        for (const char* name : {"hemicubes", "pictures"})
            if (options_.record) image::check_target(recording_file(options_, name));
        if (options_.resume)
            solver_.resume(
                load_solution(saved_file(), solver_.model(), options_.solver.form_factors));
        if (options_.resume) saved_shots_ = solver_.solution().shots;
        if (options_.shares) follow_shares();
        steps_ = {step_of(solver_.model(), solver_.solution(), 0, 0)};
        if (options_.resume && writes_) steps_ = resumed_curve(options_.output, steps_.front());
        hemicubes_ = steps_.back().hemicubes;
        seconds_before_ = steps_.back().seconds;
        folder.commit();
        if (writes_) announce_last_save();
        solver_.draw_with(meet(options_.rank, options_.output, work()));
        try {
            while (!finished() && shoot()) after_shot();
        } catch (const Error& lost) {
            save_before(lost);
        }
        finish();
        if (!options_.changes.empty()) change();
        return Done;
    }

private:
    std::filesystem::path saved_file() const { return options_.output / "pixmaps.exr"; }

    Solved shown() const { return {solver_.model(), solver_.solution()}; }

    void follow_shares() {
        const radiosity::PixmapModel& model = solver_.model();
        shares_ = options_.resume
                      ? load_shares(options_.output, model, options_.solver.form_factors)
                      : radiosity::initial_shares(model);
        if (!shares_.empty() && shares_.front().solution.shots != solver_.solution().shots)
            throw Error(
                (options_.output / "share_1.exr").string(), 0,
                fmt::format("has {} shots; expected {}, as {}", shares_.front().solution.shots,
                            solver_.solution().shots, saved_file().string()));
        std::vector<radiosity::Solution> parts;
        for (radiosity::Share& share : shares_) parts.push_back(std::move(share.solution));
        solver_.follow(std::move(parts));
    }

    void take_shares() {
        for (std::size_t i = 0; i < shares_.size(); ++i) shares_[i].solution = solver_.parts()[i];
    }

    bool finished() const {
        const Step& last = steps_.back();
        if (stalled_) return true;
        return options_.shots >= 0 ? last.shots >= static_cast<std::uint64_t>(options_.shots)
                                   : last.unshot <= options_.until;
    }

    bool shoot() {
        const auto shot = solver_.shoot();
        if (!shot) return false;
        hemicubes_ += shot->hemicubes;
        steps_.push_back(step_of(solver_.model(), solver_.solution(),
                                 seconds_before_ + seconds_since(begin_), hemicubes_));
        stalled_ = options_.shots < 0 && stall_.after_shot(steps_.back().unshot);
        progress_.at(fmt::format("shot {}, {:.2f} % unshot", steps_.back().shots,
                                 100 * steps_.back().unshot));
        return true;
    }

    /// What all processes must have alike.
    std::string work() const {
        const radiosity::Solution& now = solver_.solution();
        const dvec3 unshot = radiosity::books(solver_.model(), now).unshot;
        return fmt::format(
            "gw {} model {} {} row_memory {} shots {} of {} until {} unshot {} {} {}", version(),
            radiosity::fingerprint(solver_.model()),
            radiosity::fingerprint(options_.solver.form_factors), options_.solver.row_memory,
            now.shots, options_.shots, options_.until, unshot.x, unshot.y, unshot.z);
    }

    /// Another process is lost; the state is that of the last whole shot.
    [[noreturn]] void save_before(const Error& lost) {
        if (!writes_ || !options_.save || options_.rank.count == 1) throw;
        image::OutputSet files(session_.inputs);
        put_saved(files);
        put_curve(steps_, options_.output, files);
        files.commit();
        throw Error(fmt::format("{}; {} has the {} shots till then: --resume goes on from there",
                                lost.what(), saved_file().string(), solver_.solution().shots));
    }

    void after_shot() {
        if (!writes_) return;
        if (options_.every > 0 &&
            solver_.solution().shots % static_cast<std::uint64_t>(options_.every) == 0) {
            image::OutputSet files(session_.inputs);
            RadiosityPictures(options_, scene_, session_)
                .put(shown(), fmt::format("shot_{:06}", solver_.solution().shots), files);
            put_index(files, options_.output, session_);
            files.commit();
        }
        if (options_.save && seconds_since(saved_at_) > seconds_between_saves) {
            image::OutputSet files(session_.inputs);
            put_saved(files);
            put_curve(steps_, options_.output, files);
            files.commit();
            saved_at_ = Clock::now();
            saved_shots_ = solver_.solution().shots;
        }
        announce_last_save();
    }

    // However the process ends, the last complete save exists: files are renamed when complete.
    void announce_last_save() {
        const std::string shots =
            fmt::format("gw: stopped after {} shots; ", solver_.solution().shots);
        interruption_.say(saved_shots_
                              ? fmt::format("{}{} has the first {}: --resume goes on from there\n",
                                            shots, saved_file().string(), *saved_shots_)
                              : shots + "nothing was saved\n");
    }

    void put_saved(image::OutputSet& files) {
        put_solution(files, saved_file(), solver_.model(), options_.solver.form_factors,
                     solver_.solution());
        take_shares();
        put_shares(files, options_.output, solver_.model(), options_.solver.form_factors, shares_);
    }

    void finish() {
        if (!writes_) return;
        image::OutputSet files(session_.inputs);
        std::string text =
            RadiosityPictures(options_, scene_, session_).put(shown(), "picture", files);
        text += lux_lines(options_, shown());
        if (options_.light_maps) text += put_light_maps(options_, scene_, shown(), "", files);
        if (options_.save) put_saved(files);
        if (options_.shares) text += put_final_shares(files);
        put_report(steps_, options_.output, files);
        put_index(files, options_.output, session_);
        files.commit();
        const Step& last = steps_.back();
        const radiosity::PixmapModel& model = solver_.model();
        if (stalled_) print_warning(radiosity::why_stalled(model, last.shots, last.unshot));
        print(fmt::format("{}, {}, {}, {}\n",
                          inspect::plural(model.figures.size(), "figure", "figures"),
                          inspect::plural(model.pixmaps.size(), "pixmap", "pixmaps"),
                          inspect::plural(std::uint64_t(model.texel_count()), "texel", "texels"),
                          inspect::plural(model.patches.size(), "patch", "patches")));
        print(fmt::format(
            "{}, {}, {:.1f} s: absorbed {:.4f}, unshot {:.4f}, escaped {:.4f} of the emitted "
            "energy; books off by {:.1e}\n{}",
            inspect::plural(std::uint64_t(last.shots), "shot", "shots"),
            inspect::plural(std::uint64_t(last.hemicubes), "hemicube", "hemicubes"), last.seconds,
            last.absorbed, last.unshot, last.escaped, last.imbalance, text));
    }

    std::string put_final_shares(image::OutputSet& files) {
        if (!options_.save) {
            take_shares();
            put_shares(files, options_.output, solver_.model(), options_.solver.form_factors,
                       shares_);
        }
        radiosity::PixmapModel alone = solver_.model();
        if (options_.light_maps)
            for (std::size_t i = 0; i < shares_.size(); ++i) {
                alone.E = shares_[i].E;
                put_light_map_values(options_, {alone, shares_[i].solution},
                                     fmt::format("share_{}_", i + 1), files);
            }
        return text_of(shares_, solver_.model());
    }

    // [F4] Shoots the difference; with --anew, also solves the changed scene from the beginning.
    void change() {
        scene::Scene changed = scene_;
        apply_changes(options_.changes, changed);
        progress_.at("changing");
        const auto begin = Clock::now();
        const radiosity::Update update = solver_.update(lit_model(changed, options_));
        const int more = update.hemicubes + solve(solver_);
        if (!writes_) return;
        const std::string sent =
            update.anew ? "the solution begun again"
                        : fmt::format("the light of {} sent anew",
                                      inspect::plural(update.patches, "patch", "patches"));
        print(fmt::format("changed: {}, {} hemicubes, {:.2f} s to {:.4f} unshot\n", sent, more,
                          seconds_since(begin), unshot(solver_)));
        image::OutputSet files(session_.inputs);
        const std::string text =
            RadiosityPictures(options_, changed, session_).put(shown(), "changed", files) +
            lux_lines(options_, shown());
        put_index(files, options_.output, session_);
        files.commit();
        print(text);
        if (options_.anew) compare(lit_model(changed, options_));
    }

    void compare(radiosity::PixmapModel model) {
        progress_.at("solving anew");
        const auto begin = Clock::now();
        radiosity::Solver anew(std::move(model), options_.solver);
        const int hemicubes = solve(anew);
        print(fmt::format(
            "anew: {} hemicubes, {:.2f} s to {:.4f} unshot; "
            "radiosities differ by {:.2f} % of their mean\n",
            hemicubes, seconds_since(begin), unshot(anew), 100 * mean_difference(solver_, anew)));
    }

    static double unshot(const radiosity::Solver& solver) {
        return radiosity::books(solver.model(), solver.solution()).unshot_share();
    }

    /// Shoots until the unshot share is that before the change. Returns the number of hemicubes.
    int solve(radiosity::Solver& solver) const {
        const double until = std::max(options_.until, steps_.back().unshot);
        int hemicubes = 0;
        radiosity::Stall stall(solver.model().patches.size());
        while (unshot(solver) > until) {
            const auto shot = solver.shoot();
            if (!shot) break;
            hemicubes += shot->hemicubes;
            if (stall.after_shot(unshot(solver))) break;
        }
        return hemicubes;
    }

    const RadiosityOptions& options_;
    Session& session_;
    Progress& progress_;
    const scene::Scene& scene_;
    radiosity::Solver solver_;
    radiosity::Stall stall_;
    std::vector<radiosity::Share> shares_;  ///< their solutions follow the solver's
    bool stalled_ = false;
    bool writes_ = options_.rank.number == 0;
    Interruption interruption_;
    std::optional<std::uint64_t> saved_shots_;  ///< in DIR/pixmaps.exr
    std::vector<Step> steps_;
    int hemicubes_ = 0;
    double seconds_before_ = 0;  ///< of the run that is continued
    Clock::time_point begin_ = Clock::now(), saved_at_ = begin_;
};

int compute(RadiosityOptions options, Session session) {
    check(options);
    if (options.rank.number > 0) options.picture.quiet = true;
    Progress progress("reading", options.picture.quiet);
    render::SceneInput input = read_input(options.picture, session);
    for (dvec3& point : options.lux_at) point -= input.origin;
    for (auto& [eye, at] : options.views) {
        eye -= input.origin;
        at -= input.origin;
    }
    const scene::Scene scene = ready_scene(options.picture, std::move(input));
    if (!options.picture.quiet) {
        print_warnings_of(scene, options.picture.size, scene::DrawnBy::Depth);
        print_warnings(scene::left_out_by_radiosity(scene));
    }
    // One thread draws the hemicubes of a recording, so that their order is fixed.
    options.solver.form_factors.threads = options.record ? 1 : options.picture.threads;
    CommandRecorder recorder;
    if (options.record) session.recorder = &recorder;
    options.solver.form_factors.make_machine = [&session](int size) {
        return recorded(make_fast(radiosity::id_profile(), size, size, {.threads = 1}), size, size,
                        session.recorder);
    };
    check_lux(options, scene);
    radiosity::PixmapModel model = lit_model(scene, options);
    if (!options.picture.quiet) print_warnings(radiosity::left_out(model));
    if (!options.form_factor.empty()) {
        print_form_factor(options, model, progress);
        return Done;
    }
    if (!options.mix.empty()) return show_mix(options, session, scene, std::move(model));
    const int code = Run(options, session, scene, std::move(model), progress).run();
    if (options.record) put_recordings(recorder, options, session);
    return code;
}

}  // namespace

Command add_radiosity(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("radiosity", "Light that is reflected diffusely, solved in pixmaps");
    const auto options = std::make_shared<RadiosityOptions>();
    add_radiosity_options(*command, *options);
    command->footer(
        "Example:\n"
        "  build/release/bin/gw radiosity scenes/radiosity/cornell.toml -o box --shots 60 --gamma "
        "2.2");
    return {command, [options](Session& session) { return compute(*options, session); }};
}

}  // namespace gw::apps
