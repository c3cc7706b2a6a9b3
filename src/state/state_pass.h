// Saves, checks and restores the state of classes with a single list of their members.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "checks/checks.h"
#include "drench/state.h"

namespace drench {

// One pass over a state. A class with state passes its members, one after the other, to the functions below,
// in its own function `state(StatePass&)`, which has access through a friend declaration. The kind of the
// pass determines what happens to them. A saved state is first checked completely, which changes nothing;
// restoring it after that cannot fail.
class StatePass {
  public:
    enum class Kind { save, check, restore };

    explicit StatePass(StateWriter& writer) : kind_(Kind::save), writer_(&writer) {}
    StatePass(StateReader& reader, Kind kind) : kind_(kind), reader_(&reader) {}

    bool saves() const { return kind_ == Kind::save; }
    bool restores() const { return kind_ == Kind::restore; }
    // Whether there is another saved value. @pre a pass that does not save
    bool hasMore() const { return reader_->left() > 0; }

    template <typename Part>
    void part(Part& part) {
        part.state(*this);
    }

    // The value that is being saved, or the saved one.
    // @throws std::runtime_error for a saved value out of range
    template <typename Number>
    Number value(Number now, double min = -unlimited, double max = unlimited) {
        if (saves()) {
            writer_->write(now);
            return now;
        }
        const Number read = reader_->read<Number>();
        if (!(double(read) >= min && double(read) <= max)) refuseSaved(read, min, max);
        return read;
    }
    std::string value(const std::string& now) {
        if (!saves()) return reader_->readText();
        writer_->write(now);
        return now;
    }
    // The same for a member, which is set in a restoring pass.
    template <typename Number>
    void number(Number& member, double min = -unlimited, double max = unlimited) {
        const Number passed = value(member, min, max);
        if (restores()) member = passed;
    }
    void flag(bool& member) { number(member, 0, 1); }
    void text(std::string& member) {
        std::string passed = value(member);
        if (restores()) member = std::move(passed);
    }
    // An index or a size, as 8 bytes on every machine.
    void index(std::size_t& member, std::size_t max) {
        const auto passed = value(static_cast<std::uint64_t>(member), 0, double(max));
        if (restores()) member = static_cast<std::size_t>(passed);
    }
    void vector(Eigen::Vector3d& member) {
        constexpr double farthest = 1e15;
        for (double& component : member) number(component, -farthest, farthest);
    }
    // All elements of a vector whose size does not change.
    template <typename Number>
    void numbers(std::vector<Number>& values, double min = -unlimited, double max = unlimited) {
        for (Number& value : values) number(value, min, max);
    }
    // A number of elements. @param now  present number  @param max  largest valid number
    std::size_t count(std::size_t now, std::size_t max = std::numeric_limits<std::size_t>::max()) {
        if (saves()) {
            writer_->write(static_cast<std::uint64_t>(now));
            return now;
        }
        const std::uint64_t read = reader_->readCount(1);
        if (read > max) refuseSaved(read, std::size_t{0}, max);
        return static_cast<std::size_t>(read);
    }
    // A list whose saved length may differ. @param each  passes the members of an item
    template <typename Item, typename Each>
    void list(std::vector<Item>& items, Each each,
              std::size_t max = std::numeric_limits<std::size_t>::max()) {
        const std::size_t size = count(items.size(), max);
        if (restores()) items.clear();
        for (std::size_t i = 0; i < size; ++i) {
            Item unused{};
            if (restores()) items.emplace_back();  // one by one, so that missing bytes allocate no memory
            each(saves() ? items[i] : restores() ? items.back() : unused);
        }
    }

  protected:
    StateReader& reader() { return *reader_; }

    static constexpr double unlimited = std::numeric_limits<double>::max();

  private:
    template <typename Number, typename Limit>
    [[noreturn]] static void refuseSaved(Number value, Limit min, Limit max) {
        refuse<std::runtime_error>("a saved value is ", value, " where ", min, " to ", max, " is possible");
    }

    Kind kind_;
    StateWriter* writer_ = nullptr;
    StateReader* reader_ = nullptr;
};

}  // namespace drench
