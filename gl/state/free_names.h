// Names that Gen.. and GenLists give: the lowest that are free. Does not keep what is named.
#pragma once

#include <GL/gl.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>

namespace gw::gl {

/// Beside a map of what is named. A name is free if the map lacks it. Remembers below which names
/// there is none, so that a name costs no search from 1.
class FreeNames {
public:
    /// The names from `first` on are deleted.
    void give_back(GLuint first) {
        for (std::uint64_t* const least : {&least_, &least_of_rows_})
            *least = std::min(*least, std::max<std::uint64_t>(first, 1));
    }

    /// The first of `count` > 0 names in a row that are free; the caller puts them into the map.
    /// 0: there are none.
    template <class Value>
    GLuint take(const std::map<GLuint, Value>& named, GLuint count = 1) {
        std::uint64_t& least = count == 1 ? least_ : least_of_rows_;
        std::uint64_t first = row_from(named, least, count);
        if (first + count - 1 > std::numeric_limits<GLuint>::max())
            first = row_from(named, 1, count);  // shorter gaps were passed over
        if (first + count - 1 > std::numeric_limits<GLuint>::max()) return 0;
        least = first + count;
        return GLuint(first);
    }

private:
    template <class Value>
    static std::uint64_t row_from(const std::map<GLuint, Value>& named, std::uint64_t first,
                                  GLuint count) {
        if (first > std::numeric_limits<GLuint>::max()) return first;
        for (auto used = named.lower_bound(GLuint(first));
             used != named.end() && used->first < first + count; ++used)
            first = std::uint64_t(used->first) + 1;
        return first;
    }

    std::uint64_t least_ = 1, least_of_rows_ = 1;
};

/// Gen..: reserves n names, by values that stand for no object yet.
template <class Value>
void reserve_names(std::map<GLuint, Value>& named, FreeNames& free_names, GLsizei n,
                   GLuint* names) {
    for (GLsizei i = 0; i < n; ++i) {
        names[i] = free_names.take(named);
        named[names[i]] = {};
    }
}

}  // namespace gw::gl
