// Objects: makeobj to objreplace. Tags name places between their calls.
#include "irisgl/calls/run.h"
#include "irisgl/calls/shared.h"
#include "irisgl/state/program.h"

#include "generated/irisgl/calls.h"

#include <algorithm>
#include <optional>
#include <string>

namespace gw::irisgl::calls {

namespace {

constexpr int deepest = 64;
/// STARTTAG and ENDTAG: every object has them.
constexpr long start_tag = -2, end_tag = -3;

Objects& objects() { return program().objects; }

std::optional<std::size_t> place_of(const ObjectList& list, long tag) {
    if (tag == start_tag) return 0;
    if (tag == end_tag) return list.calls.size();
    const auto found = list.tags.find(tag);
    return found == list.tags.end() ? std::nullopt : std::optional(found->second);
}

/// The place of a tag in the open object; warns if there is none.
std::optional<std::size_t> open_place(const char* function, long tag) {
    const OpenObject& open = objects().open;
    const auto place = open.is_open() ? place_of(*open.list, tag) : std::nullopt;
    if (!place)
        warn(std::string(function) + ": tag " + std::to_string(tag) +
             "; expected a tag of the open object; it is ignored");
    return place;
}

void remove_calls(ObjectList& list, std::size_t first, std::size_t last) {
    list.calls.erase(list.calls.begin() + std::ptrdiff_t(first),
                     list.calls.begin() + std::ptrdiff_t(last));
    std::erase_if(list.tags, [&](const auto& t) { return t.second > first && t.second < last; });
    for (auto& [tag, place] : list.tags)
        if (place >= last) place -= last - first;
}

}  // namespace

void makeobj(Object n) {
    if (objects().open.is_open()) {
        warn("makeobj: an object is open; it is closed");
        closeobj();
    }
    objects().all[n] = {};
    objects().open = {.name = n, .list = &objects().all[n]};
}

void closeobj() {
    if (!objects().open.is_open()) return warn("closeobj: no object is open; it is ignored");
    objects().open = {};
}

void editobj(Object n) {
    if (objects().open.is_open())
        return warn("editobj: an object is open; expected closeobj before it; it is ignored");
    const auto found = objects().all.find(n);
    if (found == objects().all.end()) return makeobj(n);
    objects().open = {.name = n, .list = &found->second, .at = found->second.calls.size()};
}

void delobj(Object n) {
    if (objects().open.is_open() && objects().open.name == n)
        return warn("delobj: the object is open; it is ignored");
    if (objects().depth > 0) return warn("delobj: an object is being called; it is ignored");
    objects().all.erase(n);
}

void callobj(Object n) {
    const auto found = objects().all.find(n);
    if (found == objects().all.end() || objects().depth >= deepest) return;
    if (!objects().called.insert(n).second)
        return warn("callobj: object " + std::to_string(n) + " calls itself; it is ignored");
    ++objects().depth;
    objects().is_pruned = false;
    ObjectScope scope(n);
    for (std::size_t i = 0; i < found->second.calls.size() && !objects().is_pruned; ++i) {
        const Call& call = found->second.calls[i];
        scope.at(i, call.function);
        call.carry_out();
    }
    objects().is_pruned = false;
    objects().called.erase(n);
    --objects().depth;
}

Object genobj() {
    const auto& all = objects().all;
    long& last = objects().last_generated;
    last = std::max(last, all.empty() ? 0L : all.rbegin()->first) + 1;
    return last;
}

Boolean isobj(Object n) { return objects().all.contains(n) ? 1 : 0; }
Object getopenobj() { return objects().open.is_open() ? objects().open.name : -1; }

void maketag(Tag t) {
    OpenObject& open = objects().open;
    if (!open.is_open()) return warn("maketag: no object is open; it is ignored");
    open.list->tags[t] = open.at;
}

Tag gentag() {
    long last = 0;
    for (const auto& [name, list] : objects().all)
        if (!list.tags.empty()) last = std::max(last, list.tags.rbegin()->first);
    if (objects().open.is_open()) maketag(last + 1);
    return last + 1;
}

Boolean istag(Tag t) {
    const OpenObject& open = objects().open;
    return open.is_open() && place_of(*open.list, t) ? 1 : 0;
}

void deltag(Tag t) {
    if (open_place("deltag", t)) objects().open.list->tags.erase(t);
}

void newtag(Tag created, Tag known, Offset offset) {
    const auto place = open_place("newtag", known);
    if (!place) return;
    ObjectList& list = *objects().open.list;
    list.tags[created] =
        std::size_t(std::clamp(long(*place) + offset, 0L, long(list.calls.size())));
}

void objinsert(Tag t) {
    const auto place = open_place("objinsert", t);
    if (!place) return;
    objects().open.at = *place;
    objects().open.replaced = 0;
}

void objreplace(Tag t) {
    const auto place = open_place("objreplace", t);
    if (!place) return;
    OpenObject& open = objects().open;
    std::size_t next = open.list->calls.size();
    for (const auto& [tag, at] : open.list->tags)
        if (at > *place) next = std::min(next, at);
    open.at = *place;
    open.replaced = next - *place;
}

void objdelete(Tag t1, Tag t2) {
    const auto first = open_place("objdelete", t1), last = open_place("objdelete", t2);
    if (!first || !last || *first >= *last) return;
    remove_calls(*objects().open.list, *first, *last);
    objects().open.at = *first;
    objects().open.replaced = 0;
}

void compactify(Object) {}
void chunksize(long) {}

}  // namespace gw::irisgl::calls
