// Form factors as bytes for other processes, and processes that draw them for each other.
#include "gw/error.h"
#include "radiosity/solver/solver.h"
#include "tests/radiosity/scenes.h"

#include <gtest/gtest.h>

#include <barrier>
#include <thread>

namespace gw::radiosity {
namespace {

const SolverOptions coarse{
    {.hemicube = 32, .points = {.smallest_of_pixmap = 1.0 / 4}, .threads = 1}};

PixmapModel box() {
    scene::Scene scene = closed_box({1, 1, 1}, 0.5f, 0);
    scene.materials[1].Kd = {0.9f, 0.1f, 0.4f};
    scene.materials[0].Ke = {1, 2, 3};
    return make_model(scene, {.texels_per_unit = 4});
}

/// Threads in place of processes.
class Together {
public:
    explicit Together(std::size_t count) : texts_(count), barrier_(std::ptrdiff_t(count)) {}

    class One : public RowExchange {
    public:
        One(Together& all, std::size_t rank) : all_(all), rank_(rank) {}
        std::size_t rank() const override { return rank_; }
        std::size_t processes() const override { return all_.texts_.size(); }
        std::vector<std::string> exchange(const std::string& mine) override {
            all_.texts_[rank_] = mine;
            all_.barrier_.arrive_and_wait();
            std::vector<std::string> texts = all_.texts_;
            all_.barrier_.arrive_and_wait();
            ++exchanges;
            return texts;
        }
        int exchanges = 0;

    private:
        Together& all_;
        std::size_t rank_;
    };

private:
    std::vector<std::string> texts_;
    std::barrier<> barrier_;
};

/// As of a process that draws a row of its own.
DrawnRows drawn(const PixmapModel& model) {
    return {compact(FormFactors(model, coarse.form_factors).from_quarters(1)), 3};
}

}  // namespace

TEST(Ranks, ThreeProcessesHaveTheBitsOfOne) {
    constexpr int shots = 60;
    Solver alone(box(), coarse);
    std::vector<int> hemicubes;
    for (int i = 0; i < shots; ++i) hemicubes.push_back(alone.shoot().value().hemicubes);
    for (const std::size_t memory : {std::size_t{1} << 30, std::size_t{0}}) {
        Together together(3);
        std::vector<Solution> solutions(3);
        std::vector<std::vector<int>> counts(3);
        std::vector<int> exchanges(3);
        std::vector<std::thread> threads;
        for (std::size_t rank = 0; rank < 3; ++rank)
            threads.emplace_back([&, rank] {
                SolverOptions options = coarse;
                options.row_memory = memory;
                Solver solver(box(), options);
                const auto one = std::make_shared<Together::One>(together, rank);
                solver.draw_with(one);
                for (int i = 0; i < shots; ++i)
                    counts[rank].push_back(solver.shoot().value().hemicubes);
                solutions[rank] = solver.solution();
                exchanges[rank] = one->exchanges;
            });
        for (std::thread& thread : threads) thread.join();
        for (std::size_t rank = 0; rank < 3; ++rank) {
            EXPECT_TRUE(solutions[rank] == alone.solution()) << rank;
            if (memory == 0) continue;
            EXPECT_EQ(counts[rank], hemicubes) << rank;
            // what was drawn ahead is used: far fewer steps than shots
            EXPECT_LT(exchanges[rank], 2 * shots / 3) << rank;
        }
    }
}

TEST(Ranks, RowsComeBackFromTheirBytes) {
    const PixmapModel model = box();
    const DrawnRows before = drawn(model), after = rows_from(to_bytes(before));
    EXPECT_EQ(after.hemicubes, 3);
    ASSERT_EQ(after.rows.size(), before.rows.size());
    for (std::size_t i = 0; i < before.rows.size(); ++i) {
        const auto list_of = [](const CompactRow& row) {
            std::vector<std::pair<std::uint32_t, double>> list;
            row.for_each([&](std::uint32_t t, double factor) { list.emplace_back(t, factor); });
            return list;
        };
        EXPECT_FALSE(list_of(before.rows[i]).empty());
        EXPECT_EQ(list_of(before.rows[i]), list_of(after.rows[i]));
        EXPECT_EQ(before.rows[i].backs(), after.rows[i].backs());
        EXPECT_EQ(before.rows[i].escaped(), after.rows[i].escaped());
        EXPECT_EQ(before.rows[i].sum(), after.rows[i].sum());
    }
}

TEST(Ranks, BytesOfAnotherLengthAreRefused) {
    const std::string good = to_bytes(drawn(box()));
    for (std::size_t size = 0; size < good.size(); size += 7)
        EXPECT_THROW(rows_from(good.substr(0, size)), Error) << size;
    EXPECT_THROW(rows_from(good + "x"), Error);
    std::string many = good;
    many[7] = 1;  // 2^56 rows
    EXPECT_THROW(rows_from(many), Error);
}

}  // namespace gw::radiosity
