// Claims: no algorithm needs a stack that grows with the scene. A closed convex body is one chain
// of a BSP tree: every face has all others behind it.
#include "tests/hiddensurface/deep_scenes.h"

#include <gtest/gtest.h>
#include <pthread.h>

namespace gw::hiddensurface {
namespace {

/// Full-screen cards, each tilted a little more than the one before, so that the nearest corner is
/// never that of the card that is seen.
scene::Scene fan_of_cards(int cards) {
    MeshData data{.primitive = Primitive::Quads};
    for (int k = 0; k < cards; ++k) {
        const float slope = 1.5f * float(k + 1) / float(cards);
        for (const auto& [x, y] :
             {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
            data.positions.push_back(vec3(float(x), float(y), slope * float(x)));
    }
    return polygon_scene(std::move(data));
}

struct Task {
    const Algorithm* algorithm;
    const Input* input;
    std::uint64_t spans = 0;
};

void* run_algorithm(void* argument) {
    auto* task = static_cast<Task*>(argument);
    StepLog none;
    task->spans = task->algorithm->run(*task->input, none).counts.spans;
    return nullptr;
}

/// Runs an algorithm on a stack of so many bytes.
void run_on_stack(std::size_t bytes, Task& task) {
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    ASSERT_EQ(pthread_attr_setstacksize(&attributes, bytes), 0);
    pthread_t thread;
    ASSERT_EQ(pthread_create(&thread, &attributes, run_algorithm, &task), 0);
    pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
}

}  // namespace

TEST(DeepScenes, NeedNoDeepStack) {
    for (const scene::Scene& scene : {prism(1500), fan_of_cards(150)}) {
        const scene::View view = scene::make_view(scene, 64, 48);
        const Input input = make_input(scene, view, vgx());
        for (const Algorithm& algorithm : algorithms()) {
            SCOPED_TRACE(algorithm.name);
            Task task{&algorithm, &input};
            run_on_stack(std::size_t{256} << 10, task);
        }
    }
}

}  // namespace gw::hiddensurface
