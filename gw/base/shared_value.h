// A value that its copies share: a copy costs a pointer. Does not change under anyone's hands.
#pragma once

#include <memory>
#include <utility>

namespace gw {

template <class T>
class SharedValue {
public:
    SharedValue() : SharedValue(T{}) {}
    SharedValue(T value) : value_(std::make_shared<T>(std::move(value))) {}

    const T& operator*() const { return *value_; }
    const T* operator->() const { return value_.get(); }
    operator const T&() const { return *value_; }
    /// The value, to be changed. No copy changes with it.
    T& edit() {
        if (value_.use_count() != 1) value_ = std::make_shared<T>(*value_);
        return *value_;
    }
    bool operator==(const SharedValue& other) const {
        return value_ == other.value_ || *value_ == *other.value_;
    }

private:
    std::shared_ptr<T> value_;
};

}  // namespace gw
