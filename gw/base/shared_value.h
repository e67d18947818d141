// A value that its copies share: a copy costs a pointer. Does not change under anyone's hands.
#pragma once

#include <memory>
#include <utility>

namespace gw {

/// Whether no other pointer shares the object any more. Then other threads have done what they did
/// through theirs: a pointer that goes comes after those that went before.
template <class T>
bool is_alone(const std::shared_ptr<T>& pointer) {
    if (pointer.use_count() != 1) return false;
    static_cast<void>(std::shared_ptr<T>(pointer));
    return true;
}

template <class T>
class SharedValue {
public:
    SharedValue() : SharedValue(T{}) {}
    SharedValue(T value) : value_(std::make_shared<T>(std::move(value))) {}

    const T& operator*() const { return *value_; }
    const T* operator->() const { return value_.get(); }
    operator const T&() const { return *value_; }
    /// Whether no copy shares it any more. Then other threads have done what they did with theirs.
    bool is_alone() const { return gw::is_alone(value_); }
    /// The value, to be changed. No copy changes with it.
    T& edit() {
        if (!is_alone()) value_ = std::make_shared<T>(*value_);
        return *value_;
    }
    bool operator==(const SharedValue& other) const {
        return value_ == other.value_ || *value_ == *other.value_;
    }

private:
    std::shared_ptr<T> value_;
};

}  // namespace gw
