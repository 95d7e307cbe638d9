#pragma once

#include <memory>
#include <utility>

namespace steplab {

/// A value of any class that implements Face: copied by Face::copy(), which returns a std::unique_ptr<Face>. As a
/// constant it gives constant access only.
template <class Face>
class Polymorphic {
public:
    explicit Polymorphic(std::unique_ptr<Face> held) : held_(std::move(held)) {}
    Polymorphic(const Polymorphic& other) : held_(other.held_->copy()) {}
    Polymorphic(Polymorphic&&) noexcept = default;
    Polymorphic& operator=(Polymorphic other) noexcept {
        held_ = std::move(other.held_);
        return *this;
    }
    ~Polymorphic() = default;

    Face* operator->() { return held_.get(); }
    const Face* operator->() const { return held_.get(); }

private:
    std::unique_ptr<Face> held_;
};

}  // namespace steplab
