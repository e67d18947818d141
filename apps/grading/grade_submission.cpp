#include "apps/grading/grade_submission.h"

#include "apps/command/limited_run.h"
#include "gw/error.h"
#include "gw/escape_controls.h"
#include "hiddensurface/run/messages.h"
#include "image/output/output_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>

namespace gw::apps {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Folders of one slot, empty at the beginning of a submission.
struct Places {
    Places(const fs::path& scratch, int slot)
        : all(scratch / std::to_string(slot)),
          files(all / "files"),
          work(all / "work"),
          answers(all / "answers") {
        fs::remove_all(all);
        for (const fs::path& folder : {all, files, work, answers}) fs::create_directory(folder);
        fs::permissions(all, fs::perms(0711));
        fs::permissions(files, fs::perms(0755));
        fs::permissions(answers, fs::perms(0700));
    }
    /// An empty folder that belongs to a program.
    void renew_work(int owner) const {
        fs::remove_all(work);
        fs::create_directory(work);
        fs::permissions(work, fs::perms(0700));
        if (::geteuid() == 0 && ::chown(work.c_str(), uid_t(owner), gid_t(owner)) != 0)
            throw Error(work.string() + ": cannot be given to user " + std::to_string(owner));
    }
    fs::path all, files, work, answers;
};

/// A computer may be busy, and a program may wait: by the clock it gets four times as long.
constexpr int clock_for_processor = 4;

struct Mark {
    std::string outcome, feedback;
};

std::string with_errors(const std::string& what, const LimitedRun& run) {
    return run.err.empty() ? what : what + " It printed on stderr:\n" + run.err;
}

/// The mark of a program that gave no answer; none: it gave one.
std::optional<Mark> mark_without_answer(const Grading& grading, const LimitedRun& run) {
    constexpr std::size_t megabyte = std::size_t{1} << 20;
    const Mark endless{
        "endless",
        fmt::format("The program did not end after {} s of computing, or {} s by the clock.",
                    grading.allowance.seconds, grading.allowance.seconds * clock_for_processor)};
    switch (run.end) {
        case RunEnd::TooLong: return endless;
        case RunEnd::TooMuchOutput:
            return Mark{"flooding", fmt::format("The program printed more than {} MB.",
                                                grading.output / megabyte)};
        case RunEnd::TooMuchMemory:
            return Mark{"memory", fmt::format("The program used more than {} MB of memory.",
                                              grading.allowance.memory / megabyte)};
        case RunEnd::Signalled:
            return Mark{
                "crashed",
                with_errors(fmt::format("The program was ended by signal {}.", run.code), run)};
        case RunEnd::Exited: break;
    }
    if (run.code == 0) return {};
    if (run.code == 128 + SIGXCPU) return endless;
    if (run.code > 128)
        return Mark{"crashed", with_errors(fmt::format("The program was ended by signal {} ({}).",
                                                       run.code - 128, ::strsignal(run.code - 128)),
                                           run)};
    return Mark{"crashed",
                with_errors(fmt::format("The program ended with exit code {}.", run.code), run)};
}

/// "gw: /tmp/.../steps.jsonl:2: unknown polygon" without what the student cannot know.
std::string message_of(const std::string& errors, const fs::path& answer) {
    std::string text = errors.substr(0, errors.find('\n'));
    if (text.starts_with("gw: ")) text.erase(0, 4);
    const std::size_t at = text.find(answer.string());
    if (at != text.npos) text.replace(at, answer.string().size(), "steps.jsonl");
    return text;
}

std::string mistakes(const Json& played) {
    constexpr std::size_t most = 5;
    std::string text = fmt::format("{} of {} pixels are wrong.\n", played.at("wrong").get<int>(),
                                   played.at("pixels").get<int>());
    std::vector<Json> blame = played.at("blame");
    std::ranges::stable_sort(blame, [](const Json& a, const Json& b) {
        return a.at("pixels").get<int>() > b.at("pixels").get<int>();
    });
    for (std::size_t i = 0; i < std::min(most, blame.size()); ++i)
        text += blame[i].at("sentence").get<std::string>() + "\n";
    if (blame.size() > most) text += fmt::format("and {} more\n", blame.size() - most);
    return text;
}

/// The answer is anybody's text: another process reads and draws it.
Mark mark_of_answer(const Grading& grading, const GradingTask& task, const fs::path& answer,
                    const fs::path& steps) {
    const LimitedRun run = run_limited(
        {"setpriv", "--pdeathsig", "KILL", "prlimit", "--core=0", "--cpu=300",
         fs::canonical("/proc/self/exe").string(), "play", task.scene.string(), answer.string(),
         "--size", grading.size, "--steps", steps.string(), "--json", "--quiet"},
        {.seconds = 300, .memory = std::size_t{4} << 30});
    if (run.end == RunEnd::Exited && run.code == 0) return {"right", "Every pixel is right.\n"};
    const Json played = Json::parse(run.out, nullptr, false);
    if (run.end == RunEnd::Exited && run.code == 3 && played.is_object())
        return {"wrong", mistakes(played)};
    if (run.end == RunEnd::Exited && run.code == 1)
        return {"broken", message_of(run.err, answer) + "\n"};
    return {"broken", "The answer could not be played within 300 s and 4096 MB.\n"};
}

GradedScene grade_scene(const Grading& grading, const GradingTask& task, const WayToRun& way,
                        const Places& places, const fs::path& folder, int slot) {
    places.renew_work(61000 + slot);
    const Confined confined{places.files, task.polygons, places.work, way.script, way.file, slot};
    const LimitedRun run = run_limited(confined_words(grading.allowance, confined),
                                       {double(grading.allowance.seconds) * clock_for_processor,
                                        grading.output, grading.allowance.memory});
    end_leftovers(grading.allowance, slot);
    const fs::path steps = folder / task.name, answer = places.answers / "steps.jsonl";
    std::optional<Mark> mark = mark_without_answer(grading, run);
    if (!mark) {
        image::write_file(answer, run.out);
        mark = mark_of_answer(grading, task, answer, steps);
    }
    const bool is_right = mark->outcome == "right";
    const bool has_player = fs::exists(steps / "player.html");
    return {task.name,
            mark->outcome,
            is_right ? grading.points : 0,
            grading.points,
            run.seconds,
            escape_controls(hiddensurface::messages_in(mark->feedback, grading.language), "\n\t"),
            has_player ? task.name + "/player.html" : ""};
}

}  // namespace

GradedSubmission grade_submission(const Grading& grading, const Submission& submission,
                                  const fs::path& folder, bool resume, int slot) {
    const Places places(grading.scratch, slot);
    WayToRun way = copied(submission, places.files, grading.allowance.disk, grading.command);
    GradedSubmission graded{submission.name, "", {}, ""};
    graded.digest = content_of(places.files) + grading.about;
    const fs::path results = folder / "results.json";
    if (resume)
        if (auto before = read_results(results); before && before->digest == graded.digest) {
            before->name = submission.name;
            return *before;
        }
    if (!way.program.empty() && !has_program(grading.allowance, way.program)) {
        graded.lacks = way.program;
        graded.digest = "";
        way.fault = "needs " + way.program + ", which the grading computer does not have";
    }
    for (const GradingTask& task : grading.tasks) {
        fs::remove_all(folder / task.name);
        graded.scenes.push_back(
            way.fault.empty()
                ? grade_scene(grading, task, way, places, folder, slot)
                : GradedScene{
                      task.name, "no program", 0, grading.points, 0,
                      escape_controls(hiddensurface::messages_in(
                                          "The submission " + way.fault + ".\n", grading.language),
                                      "\n"),
                      ""});
    }
    image::write_file(results, results_json(graded));
    return graded;
}

}  // namespace gw::apps
