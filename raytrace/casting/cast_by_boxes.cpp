// Boxes around objects, and boxes in boxes.
#include "raytrace/casting/cast_methods.h"

#include <algorithm>
#include <numeric>

namespace gw::raytrace {
namespace {

/// A box around every object [L12]. Shapes of one object follow each other.
class BoundingVolumes : public RayCaster {
public:
    explicit BoundingVolumes(const ShapeTester& tester) : tester_(tester) {
        const auto& shapes = tester.shapes();
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            if (i == 0 || shapes[i].object != shapes[i - 1].object) volumes_.push_back({{}, i, i});
            volumes_.back().box.add(box_of(shapes[i]));
            volumes_.back().last = i + 1;
        }
    }

private:
    std::optional<CastHit> search(const Ray& ray, CastCounts& counts,
                                  std::vector<CastVisit>* visits) const override {
        ++counts.rays;
        std::optional<CastHit> hit;
        for (const Volume& volume : volumes_) {
            ++counts.boxes;
            const auto in = through(volume.box, ray);
            const bool enters = in && !(hit && in->from > hit->t);
            if (visits) visits->push_back({volume.box, enters ? volume.last - volume.first : 0});
            for (std::size_t i = volume.first; enters && i < volume.last; ++i)
                tester_.test(ray, i, hit, counts);
        }
        return hit;
    }

    struct Volume {
        Box box;
        std::size_t first = 0, last = 0;
    };
    ShapeTester tester_;
    std::vector<Volume> volumes_;
};

/// Boxes in boxes [L12], halved at the middle of the longest side.
class BoxHierarchy : public RayCaster {
public:
    explicit BoxHierarchy(const ShapeTester& tester)
        : tester_(tester), order_(tester.shapes().size()) {
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        for (const CastShape& s : tester.shapes()) boxes_.push_back(box_of(s));
        if (!order_.empty()) build(0, order_.size());
    }

private:
    std::optional<CastHit> search(const Ray& ray, CastCounts& counts,
                                  std::vector<CastVisit>* visits) const override {
        ++counts.rays;
        std::optional<CastHit> hit;
        if (!nodes_.empty()) descend(0, ray, hit, counts, visits);
        return hit;
    }

    static constexpr std::size_t most_in_leaf = 4;
    struct Node {
        Box box;
        std::size_t first = 0, last = 0;
        std::size_t left = 0, right = 0;  ///< 0: a leaf
    };

    std::size_t build(std::size_t first, std::size_t last) {
        const std::size_t index = nodes_.size();
        nodes_.push_back({{}, first, last});
        Box box;
        for (std::size_t i = first; i < last; ++i) box.add(boxes_[order_[i]]);
        nodes_[index].box = box;
        if (last - first <= most_in_leaf) return index;
        int axis = 0;
        for (int k = 1; k < 3; ++k)
            if (box.high[k] - box.low[k] > box.high[axis] - box.low[axis]) axis = k;
        const auto middle = [&](std::size_t i) {
            return boxes_[i].low[axis] + boxes_[i].high[axis];
        };
        std::stable_sort(order_.begin() + std::ptrdiff_t(first),
                         order_.begin() + std::ptrdiff_t(last),
                         [&](std::size_t a, std::size_t b) { return middle(a) < middle(b); });
        const std::size_t left = build(first, (first + last) / 2),
                          right = build((first + last) / 2, last);
        nodes_[index].left = left;
        nodes_[index].right = right;
        return index;
    }

    void descend(std::size_t index, const Ray& ray, std::optional<CastHit>& hit, CastCounts& counts,
                 std::vector<CastVisit>* visits) const {
        const Node& node = nodes_[index];
        ++counts.boxes;
        const auto in = through(node.box, ray);
        const bool enters = in && !(hit && in->from > hit->t), is_leaf = node.left == 0;
        if (visits) visits->push_back({node.box, enters && is_leaf ? node.last - node.first : 0});
        if (!enters) return;
        if (is_leaf) {
            for (std::size_t i = node.first; i < node.last; ++i)
                tester_.test(ray, order_[i], hit, counts);
            return;
        }
        descend(node.left, ray, hit, counts, visits);
        descend(node.right, ray, hit, counts, visits);
    }

    ShapeTester tester_;
    std::vector<std::size_t> order_;
    std::vector<Box> boxes_;
    std::vector<Node> nodes_;
};

}  // namespace

std::unique_ptr<RayCaster> cast_by_volumes(const ShapeTester& tester) {
    return std::make_unique<BoundingVolumes>(tester);
}

std::unique_ptr<RayCaster> cast_by_hierarchy(const ShapeTester& tester) {
    return std::make_unique<BoxHierarchy>(tester);
}

}  // namespace gw::raytrace
