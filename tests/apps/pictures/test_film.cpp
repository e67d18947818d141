// Claims of gw render --film: numbered pictures, motion blur as the mean of instants, the same files
// from several processes, a film that goes on where it was cut off and only with itself, its video.
#include "tests/apps/pictures.h"
#include "tests/apps/scene_files.h"
#include "tests/scene/gltf/gltf_text.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace gw::apps {
namespace {

class FilmCommand : public SceneTest {
protected:
    /// A white square over pixels 4 .. 11 at picture 2, which moves 4 pixels from one to the next.
    FilmCommand() { write_film("film.toml", "[camera]\neye = [0, 0, 5]\northo = 4\n", "1"); }

    /// The square goes from -x to x in pictures 1 to 3.
    void write_film(const std::string& name, const std::string& camera,
                    const std::string& x) const {
        write(name, "[film]\nrate = 1\n" + camera + R"([[object]]
name = "square"
file = "quad.obj"
material = {Ka = 0, Kd = 0, Ke = 1}
[[track]]
object = "square"
key = "translate"
times = [0, 2]
values = [[-)" + x + ", 0, 0], [" +
                        x + ", 0, 0]]\n");
    }
    std::vector<int> row_of(const std::string& name) const {
        std::vector<int> row;
        const Pixels picture = read_pixels(in(name));
        for (int x = 0; x < 16; ++x) row.push_back(int(std::lround(picture.at(x, 8)[0] * 255)));
        return row;
    }
};

}  // namespace

/// Without a camera, the fitted one sees the whole film, whichever pictures are asked for.
TEST_F(FilmCommand, FitsItsCameraToTheFilm) {
    write_film("wide.toml", "", "9");
    EXPECT_EQ(render({"wide.toml", "-o", "a.png", "--film", "1-3"}).code, 0);
    std::vector<std::size_t> lit;
    for (const char* name : {"a_001.png", "a_002.png", "a_003.png"}) {
        const Pixels picture = read_pixels(in(name));
        std::size_t count = 0;
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x) count += picture.at(x, y)[0] > 0;
        lit.push_back(count);
    }
    for (const std::size_t count : lit) EXPECT_GT(count, 0u);
    const std::string alone = bytes_of(in("a_003.png"));
    EXPECT_EQ(render({"wide.toml", "-o", "b.png", "--film", "3"}).code, 0);
    EXPECT_TRUE(bytes_of(in("b_003.png")) == alone);
}

TEST_F(FilmCommand, NumbersItsPictures) {
    EXPECT_EQ(render({"film.toml", "-o", "a.png", "--film", "2-3"}).code, 0);
    EXPECT_EQ(names(), (std::vector<std::string>{"a.png.film", "a_002.png", "a_003.png",
                                                 "film.toml", "lamps.toml", "quad.obj"}));
    EXPECT_EQ(row_of("a_002.png"),
              (std::vector<int>{0, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0}));
    EXPECT_EQ(row_of("a_003.png"),
              (std::vector<int>{0, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255}));
}

TEST_F(FilmCommand, SuperposesTheInstantsOfAnOpenShutter) {
    EXPECT_EQ(
        render({"film.toml", "-o", "a.png", "--film", "2", "--shutter", "1", "--instants", "2"})
            .code,
        0);
    EXPECT_EQ(row_of("a_002.png"), (std::vector<int>{0, 0, 0, 128, 128, 255, 255, 255, 255, 255,
                                                     255, 128, 128, 0, 0, 0}));
}

TEST_F(FilmCommand, GoesOnAtItsFirstMissingPicture) {
    EXPECT_EQ(render({"film.toml", "-o", "a.png", "--film", "1-3"}).code, 0);
    const std::string second = bytes_of(in("a_002.png")), third = bytes_of(in("a_003.png"));
    write("a_001.png", "kept");
    write("a_003.png", "drawn anew");
    std::filesystem::remove(in("a_002.png"));
    EXPECT_EQ(render({"film.toml", "-o", "a.png", "--film", "1-3", "--continue"}).code, 0);
    EXPECT_EQ(bytes_of(in("a_001.png")), "kept");
    EXPECT_TRUE(bytes_of(in("a_002.png")) == second);
    EXPECT_TRUE(bytes_of(in("a_003.png")) == third);
}

/// Pictures of two films in one series would be one film to every program.
TEST_F(FilmCommand, GoesOnOnlyWithTheSameFilm) {
    const std::vector<std::string> film{"film.toml", "-o", "a.png", "--film", "1-3"};
    const auto continued = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all = film;
        all.push_back("--continue");
        all.insert(all.end(), more.begin(), more.end());
        return render(all);
    };
    EXPECT_EQ(continued({}).code, 0);  // nothing is there yet
    const std::string second = bytes_of(in("a_002.png"));
    std::filesystem::remove(in("a_003.png"));
    const Outcome other = continued({"--samples", "2"});
    EXPECT_EQ(other.code, 1);
    EXPECT_EQ(other.err,
              "gw: a.png.film: the film was drawn with 'samples 1', not with 'samples 2'; expected "
              "the same, or no --continue\n");
    EXPECT_FALSE(std::filesystem::exists(in("a_003.png")));
    EXPECT_EQ(continued({"--threads", "2"}).code, 0);  // the same bits
    write("film.toml", bytes_of(in("film.toml")) + "\n");
    EXPECT_NE(continued({}).err.find("'scene "), std::string::npos);
    // Drawn anew with other options, what is left of the old film is not continued.
    EXPECT_EQ(render({"film.toml", "-o", "a.png", "--film", "1", "--gamma", "2"}).code, 0);
    write("a_002.png", "old");
    const auto record = std::filesystem::last_write_time(in("a.png.film"));
    std::filesystem::last_write_time(in("a_002.png"), record - std::chrono::seconds(1));
    EXPECT_EQ(continued({"--gamma", "2"}).code, 0);
    EXPECT_TRUE(bytes_of(in("a_002.png")) == second);  // black and white
    std::filesystem::remove(in("a.png.film"));
    EXPECT_NE(continued({}).err.find("a.png.film: does not exist; expected"), std::string::npos);
    write("a.png.film", "mine");
    EXPECT_NE(continued({}).err.find("a.png.film: is no record of a film"), std::string::npos);
}

/// A stand-in for ffmpeg: it writes its words into the video, or fails.
class VideoOfFilm : public FilmCommand {
protected:
    VideoOfFilm() : before_(::getenv("PATH")) {
        std::filesystem::create_directory(in("bin"));
        ::setenv("PATH", (in("bin").string() + ":/usr/bin:/bin").c_str(), 1);
    }
    ~VideoOfFilm() override { ::setenv("PATH", before_.c_str(), 1); }
    VideoOfFilm(const VideoOfFilm&) = delete;
    VideoOfFilm& operator=(const VideoOfFilm&) = delete;

    void install(const std::string& script) const {
        write("bin/ffmpeg", "#!/bin/sh\n[ \"$1\" = -version ] && exit 0\n" + script);
        std::filesystem::permissions(in("bin/ffmpeg"), std::filesystem::perms::owner_all);
    }
    Outcome film(const std::string& video, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> all{"film.toml", "-o",      "a%.png", "--film",
                                     "2-3",       "--video", video};
        all.insert(all.end(), more.begin(), more.end());
        return render(all);
    }

private:
    std::string before_;
};

TEST_F(VideoOfFilm, IsMadeOfItsPictures) {
    install("for word; do last=$word; done\necho \"$@\" > \"${last#file:}\"\n");
    const Outcome outcome = film("a.mp4");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const std::string words = bytes_of(in("a.mp4"));
    EXPECT_NE(words.find("-framerate 1 -start_number 2 -i file:a%%_%03d.png -frames:v 2 "),
              words.npos)
        << words;
    EXPECT_NE(words.find("-f mp4 file:"), words.npos);
    // A continued film has the video of all its pictures.
    std::filesystem::remove(in("a.mp4"));
    EXPECT_EQ(film("a.mp4", {"--continue"}).code, 0);
    EXPECT_EQ(bytes_of(in("a.mp4")).substr(0, 60), words.substr(0, 60));
}

TEST_F(VideoOfFilm, ThatFfmpegCannotMakeIsNotThere) {
    install(
        "for word; do last=$word; done\necho half > \"${last#file:}\"\n"
        "echo no codec >&2\necho sorry >&2\nexit 7\n");
    write("a.mp4", "before");
    const Outcome outcome = film("a.mp4");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(outcome.err, "gw: a.mp4: is not written: ffmpeg ended with code 7: no codec\n");
    EXPECT_EQ(bytes_of(in("a.mp4")), "before");
    EXPECT_TRUE(std::filesystem::exists(in("a%_003.png")));
}

/// ffmpeg prints that it cannot write, but its code is 0 unless it has -xerror.
TEST_F(VideoOfFilm, ThatTheDiskCannotHoldIsAnError) {
    install(
        "case \" $* \" in *\" -xerror \"*) code=1;; *) code=0;; esac\n"
        "echo No space left on device >&2\nexit $code\n");
    const Outcome outcome = film("a.gif");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("ffmpeg ended with code 1: No space left"), outcome.err.npos);
    EXPECT_FALSE(std::filesystem::exists(in("a.gif")));
}

TEST_F(VideoOfFilm, IsRefusedBeforeWorkIfItCannotBeMade) {
    ::setenv("PATH", in("bin").c_str(), 1);
    expect_refused(1, {"render", "film.toml", "-o", "a.png", "--film", "1", "--video", "a.mp4"},
                   {"ffmpeg cannot be run; expected it to be installed"});
    install("");
    expect_refused(2, {"render", "film.toml", "-o", "a.png", "--film", "1", "--video", "a.mpeg"},
                   {"--video 'a.mpeg': expected a name with one of .mp4, .mkv"});
    expect_refused(1, {"render", "film.toml", "-o", "a.png", "--film", "1", "--video", "no/a.mp4"},
                   {"no/a.mp4: cannot be written"});
    expect_refused(2, {"render", "film.toml", "-o", "a.png", "--video", "a.mp4"},
                   {"--video without --film"});
    expect_refused(2, {"render", "film.toml", "-o", "a.gif", "--film", "1", "--video", "a_001.gif"},
                   {"--video is one of the pictures"});
}

TEST_F(FilmCommand, TakesTheAnimationThatItNames) {
    write("m.gltf", scene::with_hop(scene::animated("translation", {1, 1, 1, 3, 3, 3}, "VEC3")));
    const std::vector<std::string> film{"m.gltf", "-o",    "a.png", "--film", "2",    "--rate",
                                        "1",      "--eye", "0,0,9", "--at",   "0,0,0"};
    const auto drawn = [&](const std::vector<std::string>& more, const std::string& warning) {
        std::vector<std::string> all = film;
        all.insert(all.end(), more.begin(), more.end());
        const Outcome outcome = render(all);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(outcome.err, warning);
        return bytes_of(in("a_002.png"));
    };
    const std::string first = drawn(
        {},
        "gw: warning: m.gltf: has 2 animations; the first is drawn; --animation takes 0 'hop' or 1\n");
    EXPECT_TRUE(drawn({"--animation", "hop"}, "") == first);
    EXPECT_TRUE(drawn({"--animation", "0"}, "") == first);
    EXPECT_FALSE(drawn({"--animation", "1"}, "") == first);
    EXPECT_TRUE(drawn({"--quiet"}, "") == first);
}

/// Eye and view of the command line count at all times, whatever moves the scene's camera.
TEST_F(FilmCommand, KeepsTheCameraOfTheCommandLine) {
    const std::string track = "[[track]]\nkey = 'eye'\ntimes = [0, 2]\nvalues = [[0, 0, 5], ";
    write("turn.toml", bytes_of(in("film.toml")) + track + "[5, 0, 5]]\n");
    EXPECT_EQ(render({"film.toml", "-o", "a.png", "--film", "2", "--eye", "5,0,1"}).code, 0);
    EXPECT_EQ(render({"turn.toml", "-o", "b.png", "--film", "2", "--eye", "5,0,1"}).code, 0);
    EXPECT_EQ(render({"turn.toml", "-o", "c.png", "--film", "2"}).code, 0);
    EXPECT_TRUE(bytes_of(in("b_002.png")) == bytes_of(in("a_002.png")));
    EXPECT_FALSE(bytes_of(in("c_002.png")) == bytes_of(in("a_002.png")));
}

TEST_F(FilmCommand, RefusesWhatIsNoFilm) {
    const auto refused = [&](const std::vector<std::string>& arguments, int code,
                             const std::string& text) {
        const Outcome outcome = render(arguments);
        EXPECT_EQ(outcome.code, code);
        EXPECT_NE(outcome.err.find(text), outcome.err.npos) << outcome.err;
    };
    refused({"lamps.toml", "-o", "a.png", "--film", "1-2"}, 1, "lamps.toml: is no film; expected");
    refused({"film.toml", "-o", "a.png", "--film", "1", "--animation", "walk"}, 1,
            "film.toml: has no animation 'walk'; expected 0");
    refused({"film.toml", "-o", "a.png", "--animation", "walk"}, 2, "without --film");
    refused({"film.toml", "-o", "a.png", "--film", "2-1"}, 2,
            "--film '2-1': expected A-B, A at most B");
    refused({"film.toml", "-o", "a.png", "--shutter", "1"}, 2, "without --film");
    refused({"film.toml", "-o", "a.png", "--film", "1", "--turntable", "2"}, 2,
            "--film with --turntable");
    refused({"film.toml", "-o", "a.png", "--film", "1", "--shutter", "2"}, 2, "--shutter");
    refused({"film.toml", "-o", "a.png", "--film", "1", "--manifest", "m.json"}, 2,
            "--film and --part cannot go with");
}

}  // namespace gw::apps
