// gw hidden --quiz: writes a handout of questions with pictures and scenes, and the key beside it.
#include "hiddensurface/quiz/quiz.h"
#include "apps/command/command.h"
#include "apps/command/terminal.h"
#include "apps/figures/folder_index.h"
#include "apps/hidden/options.h"
#include "apps/hidden/pictures.h"
#include "hiddensurface/run/styles.h"
#include "image/output/output_set.h"
#include "image/write.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace gw::apps {

namespace hs = hiddensurface;
using Json = nlohmann::ordered_json;

namespace {

/// The distance of each pixel, along its row and column, to another polygon's pixel or the border.
std::vector<int> clearance_of(const std::vector<std::uint32_t>& ids) {
    std::vector<int> clearance(ids.size(), hs::quiz_width);
    for (const auto& [dx, dy] :
         {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
        std::vector<int> reach(ids.size());
        for (int k = 0; k < int(ids.size()); ++k) {
            // The neighbour at `behind` comes first.
            const int i = dx + dy > 0 ? k : int(ids.size()) - 1 - k;
            const int x = i % hs::quiz_width - dx, y = i / hs::quiz_width - dy;
            const bool inside = x >= 0 && y >= 0 && x < hs::quiz_width && y < hs::quiz_height;
            const auto at = std::size_t(i), behind = std::size_t(y * hs::quiz_width + x);
            if (inside && ids[behind] == ids[at]) reach[at] = reach[behind] + 1;
            clearance[at] = std::min(clearance[at], reach[at]);
        }
    }
    return clearance;
}

/// Writes each polygon's number at its pixel with the largest clearance.
void write_numbers(image::Picture& picture, const std::vector<std::uint32_t>& ids) {
    const std::vector<int> clearance = clearance_of(ids);
    std::map<std::uint32_t, std::size_t> widest;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const auto [at, is_new] = widest.try_emplace(ids[i], i);
        if (clearance[i] > clearance[at->second]) at->second = i;
    }
    widest.erase(0);
    for (const auto& [id, i] : widest)
        write_text(picture, int(i) % hs::quiz_width - 5,
                   hs::quiz_height - 1 - int(i) / hs::quiz_width - 7, 2, {0, 0, 0},
                   std::to_string(id));
}

void mark(image::Picture& picture, const hs::Question& question) {
    const auto at = [&](int x, int y, const Color& color) {
        if (x >= 0 && y >= 0 && x < picture.width && y < picture.height)
            put(picture, std::size_t(y * picture.width + x), color);
    };
    if (question.row)
        for (int x = 0; x < picture.width; ++x) at(x, *question.row, white);
    if (!question.point) return;
    const int x = int(question.point->x), y = int(question.point->y);
    for (int d = 3; d <= 8; ++d)
        for (const auto& [i, k] :
             {std::pair(d, 0), std::pair(-d, 0), std::pair(0, d), std::pair(0, -d)})
            at(x + i, y + k, white);
}

/// Numbered surfaces in flat colours. A question about lines shows all sides over them. A question
/// about back faces shows the sides alone, because visible surfaces face the eye.
image::Picture picture_of(const hs::Question& question) {
    const Profile profile = vgx();
    const scene::View view = scene::make_view(question.scene, hs::quiz_width, hs::quiz_height);
    const hs::Input input = hs::make_input(question.scene, view, profile);
    const auto machine = make_fast(profile, hs::quiz_width, hs::quiz_height, {.threads = 1});
    hs::StepLog none;
    const auto ids = hs::run_on(*machine, hs::algorithm_named("z-buffer"), input, none).ids;
    const bool sides = question.kind == "facing";
    image::Picture picture = sides ? blank(hs::quiz_width, hs::quiz_height)
                                   : picture_of_ids(input, ids, flat_colors(input));
    if (sides || question.kind == "invisibility") {
        machine->execute(hs::wireframe(question.scene, view));
        for (std::size_t i = 0; i < ids.size(); ++i)
            if (machine->planes().color[i][0] > 0)
                put(picture, i, sides ? white : Color{30, 30, 30});
    }
    if (!sides) write_numbers(picture, ids);
    mark(picture, question);
    return picture;
}

std::string mtl_of(const scene::Scene& scene) {
    std::string text;
    for (const scene::Material& m : scene.materials)
        text += fmt::format("newmtl {0}\nKa {1:.9g} {2:.9g} {3:.9g}\nKd {1:.9g} {2:.9g} {3:.9g}\n",
                            m.name, m.Kd.x, m.Kd.y, m.Kd.z);
    return text;
}

std::string obj_of(const scene::Scene& scene, const std::string& mtl) {
    std::string text = "mtllib " + mtl + "\n";
    for (const scene::Object& object : scene.objects) {
        const auto& corners = object.mesh->data().positions;
        text += "o " + object.name + "\nusemtl " + scene.materials[object.material].name + "\n";
        for (const vec3& p : corners)
            text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
        text += "f";
        for (std::size_t k = 0; k < corners.size(); ++k)
            text += fmt::format(" -{}", corners.size() - k);
        text += "\n";
    }
    return text;
}

std::string toml_of(const hs::Question& question, const std::string& obj) {
    const scene::Camera& c = *question.scene.camera;
    const vec3& b = question.scene.background;
    std::string text = fmt::format(
        "background = [{:.9g}, {:.9g}, {:.9g}]\n\n[camera]\neye = [{}, {}, {}]\nat = [{}, {}, "
        "{}]\n",
        b.x, b.y, b.z, c.eye.x, c.eye.y, c.eye.z, c.at.x, c.at.y, c.at.z);
    text += c.ortho_height > 0 ? fmt::format("ortho = {}\n", c.ortho_height)
                               : fmt::format("fov = {}\n", c.fov);
    return text +
           "\n[[light]]\ndirection = [-0.4, -0.5, -0.8]\nIa = 0.4\nId = 0.6\n\n[[object]]\nfile "
           "= \"" +
           obj + "\"\n";
}

struct Handout {
    std::string text;
    Json questions = Json::array(), form = Json::object(), key = Json::array();
};

void add_question(const hs::Question& q, std::size_t number, const std::string& picture,
                  const std::string& scene, Handout& out) {
    out.text += fmt::format("{}. ({}) {}\n   Picture: {}; scene: {}\n", number, q.kind, q.text,
                            picture, scene);
    Json json{{"number", number},
              {"kind", q.kind},
              {"question", q.text},
              {"picture", picture},
              {"scene", scene}};
    Json choices = Json::object();
    for (std::size_t i = 0; i < q.choices.size(); ++i) {
        out.text += fmt::format("   {}) {}\n", char('a' + i), q.choices[i]);
        choices[std::string(1, char('a' + i))] = q.choices[i];
    }
    if (!choices.empty()) json["choices"] = std::move(choices);
    out.text += "\n";
    out.questions.push_back(json);
    out.form[std::to_string(number)] = "";
    out.key.push_back({{"number", number}, {"kind", q.kind}, {"answer", q.answer}, {"why", q.why}});
}

}  // namespace

int hidden_quiz(const HiddenOptions& options, const Session& session) {
    image::OutputSet output;
    const std::filesystem::path handout = options.quiz / "handout";
    output.make_folder(options.quiz);
    output.make_folder(handout);
    Progress progress("making questions", options.picture.quiet);
    const auto quiz = hs::make_quiz(std::uint32_t(options.seed), options.questions, options.kind);
    Handout all;
    for (std::size_t i = 0; i < quiz.size(); ++i) {
        progress.at(fmt::format("question {} of {}", i + 1, quiz.size()));
        const std::string name = fmt::format("{:02}", i + 1), picture = "picture_" + name + ".png",
                          scene = "scene_" + name;
        image::put_picture(output.add(handout / picture), picture_of(quiz[i]));
        output.add(handout / (scene + ".toml")).write_text(toml_of(quiz[i], scene + ".obj"));
        output.add(handout / (scene + ".obj")).write_text(obj_of(quiz[i].scene, scene + ".mtl"));
        output.add(handout / (scene + ".mtl")).write_text(mtl_of(quiz[i].scene));
        add_question(quiz[i], i + 1, picture, scene + ".toml", all);
    }
    const Json head{{"seed", options.seed},
                    {"size", fmt::format("{}x{}", hs::quiz_width, hs::quiz_height)}};
    Json questions = head, form{{"seed", options.seed}, {"answers", all.form}},
         key{{"seed", options.seed}, {"answers", all.key}};
    questions["questions"] = all.questions;
    output.add(handout / "questions.txt").write_text(all.text);
    output.add(handout / "questions.json").write_text(questions.dump(2) + "\n");
    output.add(handout / "answers.json").write_text(form.dump(2) + "\n");
    output.add(options.quiz / "key.json").write_text(key.dump(2) + "\n");
    put_index(output, options.quiz, session);
    output.commit();
    print(options.form == Form::Json ? questions.dump(2) + "\n" : all.text);
    return Done;
}

}  // namespace gw::apps
