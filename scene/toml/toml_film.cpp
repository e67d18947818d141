#include "scene/toml/toml_film.h"

#include "gw/error.h"
#include "scene/geometry/transform.h"
#include "scene/text/number.h"
#include "scene/text/suggest.h"
#include "scene/toml/toml_binder.h"

#include <algorithm>
#include <memory>
#include <tuple>
#include <type_traits>

namespace gw::scene {
namespace {

/// A value of a scene that a track can set.
struct Field {
    std::string name;
    std::size_t width = 1;
    Range range;
    std::function<void(const double*)> set;
    bool one_for_all = false;  ///< one number may stand for all: a grey
};

/// Appends a field for each value that a function of limits.h visits.
struct FieldList {
    std::vector<Field>& fields;

    template <class Number>
    void number(FieldName name, Number& field, Range range) const {
        if constexpr (std::is_floating_point_v<Number>)
            fields.push_back(
                {name.file, 1, range, [&field](const double* v) { field = Number(v[0]); }});
    }
    template <class Vector>
    void place(FieldName name, Vector& field) const {
        fields.push_back({name.file, 3, placeable,
                          [&field](const double* v) { field = Vector(v[0], v[1], v[2]); }});
    }
    void color(FieldName name, vec3& field) const {
        fields.push_back({name.file, 3, not_negative,
                          [&field](const double* v) { field = vec3(v[0], v[1], v[2]); }, true});
    }
};

/// What a track adds to an object's placement.
struct Motion {
    dvec3 translate{0}, rotate{0}, scale{1};
};

template <class Visit>
std::vector<Field> listed(const Visit& visit) {
    std::vector<Field> fields;
    visit(FieldList{fields});
    return fields;
}

std::vector<Field> fields_of(Camera& camera) {
    return listed([&](const FieldList& list) { visit_camera(camera, list); });
}
std::vector<Field> fields_of(Light& light) {
    return listed([&](const FieldList& list) { visit_light(light, list); });
}
std::vector<Field> fields_of(Material& material) {
    return listed([&](const FieldList& list) { visit_material(material, list); });
}
std::vector<Field> fields_of(Motion& motion) {
    std::vector<Field> fields = listed([&](const FieldList& list) {
        list.place("translate", motion.translate);
        list.place("rotate", motion.rotate);
        list.place("scale", motion.scale);
    });
    fields[1].range = {-36000, 36000};
    fields[2].one_for_all = true;
    return fields;
}

const Field* field_named(const std::vector<Field>& fields, const std::string& name) {
    const auto found = std::ranges::find(fields, name, &Field::name);
    return found == fields.end() ? nullptr : &*found;
}

struct Track {
    int line = 0;
    std::string object, light, material, key;  ///< no name: of the camera
    Keys keys;
};

/// Between keys a smooth curve may leave the range that its keys obey.
void set(const std::vector<Field>& fields, const Track& track, double time) {
    const Field& field = *field_named(fields, track.key);
    std::vector<double> values = track.keys.at(time);
    for (double& value : values) value = std::clamp(value, field.range.low, field.range.high);
    field.set(values.data());
}

/// Scaled and turned about the object's own origin, then moved.
dmat4 moved(const dmat4& world_from_object, const Motion& motion) {
    dmat4 own = world_from_object;
    own[3] = dvec4(0, 0, 0, 1);
    const dmat4 turned = rotation_xyz(motion.rotate) * scaling(motion.scale) * own;
    return translation(dvec3(world_from_object[3]) + motion.translate) * turned;
}

[[noreturn]] void fail_at(double time, const std::string& what, const Fault& fault) {
    throw Error(what + " at " + number_text(double(float(time))) + " s: " + fault.field.file +
                " is " + fault.is + "; expected " + fault.expected);
}

class Posing {
public:
    Posing(std::vector<Track> tracks, const Scene& scene, const dvec3& origin)
        : tracks_(std::move(tracks)), origin_(origin) {
        for (const Object& object : scene.objects) placed_.push_back(object.world_from_object);
    }

    void operator()(Scene& scene, double time) const {
        pose_camera(scene, time);
        for (Light& light : scene.lights) pose_light(light, time);
        for (Material& material : scene.materials)
            for (const Track& track : tracks_)
                if (!track.material.empty() && track.material == material.name)
                    set(fields_of(material), track, time);
        for (std::size_t i = 0; i < placed_.size() && i < scene.objects.size(); ++i)
            pose_object(scene.objects[i], placed_[i], time);
    }

private:
    void pose_camera(Scene& scene, double time) const {
        bool posed = false;
        for (const Track& track : tracks_) {
            if (!track.object.empty() || !track.light.empty() || !track.material.empty()) continue;
            if (!scene.camera) scene.camera.emplace();
            set(fields_of(*scene.camera), track, time);
            if (track.key == "eye") scene.camera->eye -= origin_;
            if (track.key == "at") scene.camera->at -= origin_;
            posed = true;
        }
        if (!posed) return;
        if (const auto fault = fault_of(*scene.camera)) fail_at(time, "camera", *fault);
    }
    void pose_light(Light& light, double time) const {
        for (const Track& track : tracks_) {
            if (track.light.empty() || track.light != light.name) continue;
            set(fields_of(light), track, time);
            if (track.key == "position") light.position -= vec3(origin_);
            if (const auto fault = fault_of(light))
                fail_at(time, "light '" + printable(light.name) + "'", *fault);
        }
    }
    void pose_object(Object& object, const dmat4& placed, double time) const {
        Motion motion;
        bool posed = false;
        for (const Track& track : tracks_) {
            if (track.object.empty() || track.object != object.name) continue;
            set(fields_of(motion), track, time);
            posed = true;
        }
        if (!posed) return;
        object.world_from_object = moved(placed, motion);
        if (const auto fault = fault_of(object.world_from_object))
            fail_at(time, "object '" + printable(object.name) + "'", *fault);
    }

    std::vector<Track> tracks_;
    dvec3 origin_;
    std::vector<dmat4> placed_;
};

template <class List>
void check_name(const TomlValue& table, const char* kind, const List& list) {
    const TomlValue* value = table.find(kind);
    if (!value) return;
    const std::string name = to_string(*value);
    std::vector<std::string> known;
    for (const auto& element : list) known.push_back(element.name);
    if (name.empty() || std::ranges::find(known, name) == known.end())
        value->fail(unknown(kind, name, known));
}

void read_times(const TomlValue& value, std::vector<double>& times) {
    if (value.kind != TomlKind::Array || value.elements.empty())
        value.fail_expected("an array of seconds");
    for (const TomlValue& element : value.elements) {
        const double time = to_double(element, {0, 1e6});
        if (!times.empty() && time <= times.back())
            element.fail(element.name + " has " + number_text(time) + " s after " +
                         number_text(times.back()) + "; expected increasing times");
        times.push_back(time);
    }
}

void read_values(const TomlValue& value, const Field& field, Keys& keys) {
    keys.width = field.width;
    const std::size_t n = keys.times.size();
    if (value.kind != TomlKind::Array || value.elements.size() != n)
        value.fail_expected("an array of " + std::to_string(n) + " values, one for each time");
    for (const TomlValue& element : value.elements) {
        if (field.width == 1 || (field.one_for_all && element.is_number())) {
            keys.values.insert(keys.values.end(), field.width, to_double(element, field.range));
            continue;
        }
        expect_numbers(element, field.width);
        for (const TomlValue& number : element.elements)
            keys.values.push_back(to_double(number, field.range));
    }
}

std::vector<Field> fields_of(const Track& track, Camera& camera, Light& light, Material& material,
                             Motion& motion) {
    return !track.object.empty()     ? fields_of(motion)
           : !track.light.empty()    ? fields_of(light)
           : !track.material.empty() ? fields_of(material)
                                     : fields_of(camera);
}

void check_is_only(const TomlValue& table, const Track& track, const std::vector<Track>& before) {
    const auto what = [](const Track& t) { return std::tie(t.object, t.light, t.material, t.key); };
    for (const Track& other : before)
        if (what(other) == what(track))
            table.fail("track sets the same '" + printable(track.key) + "' as that of line " +
                       std::to_string(other.line) + "; expected one track for it");
}

Track read_track(const TomlValue& table, const Scene& scene) {
    Track track{.line = table.line};
    const TomlValue* values = nullptr;
    read_table(table, {
                          key("object", track.object),
                          key("light", track.light),
                          key("material", track.material),
                          key("key", track.key),
                          {"times", [&](const TomlValue& v) { read_times(v, track.keys.times); }},
                          {"values", [&](const TomlValue& v) { values = &v; }},
                          key("interpolation", track.keys.interpolation,
                              {{"step", Interpolation::Step},
                               {"linear", Interpolation::Linear},
                               {"smooth", Interpolation::Smooth}}),
                      });
    check_name(table, "object", scene.objects);
    check_name(table, "light", scene.lights);
    check_name(table, "material", scene.materials);
    if (int(!track.object.empty()) + int(!track.light.empty()) + int(!track.material.empty()) > 1)
        table.fail(
            "track has several of object, light and material; expected one, or none for the "
            "camera");
    for (const char* needed : {"key", "times", "values"})
        if (!table.find(needed))
            table.fail("track has no " + std::string(needed) + "; expected it");
    Camera camera;
    Light light;
    Material material;
    Motion motion;
    const std::vector<Field> fields = fields_of(track, camera, light, material, motion);
    const Field* field = field_named(fields, track.key);
    if (!field) {
        std::vector<std::string> known;
        for (const Field& other : fields) known.push_back(other.name);
        table.find("key")->fail(unknown("value", track.key, known));
    }
    read_values(*values, *field, track.keys);
    return track;
}

}  // namespace

std::optional<Film> read_film(const TomlValue* film, const std::vector<const TomlValue*>& tables,
                              const Scene& scene, const dvec3& origin) {
    Film out;
    if (film)
        read_table(*film, {
                              key("rate", out.rate, {0.001, 1000}),
                              key("shutter", out.shutter, {0, 1}),
                              key("instants", out.instants, {1, 256}),
                          });
    if (film && tables.empty()) film->fail("film has no tracks; expected [[track]]");
    if (tables.empty()) return std::nullopt;
    std::vector<Track> tracks;
    for (const TomlValue* table : tables) {
        Track track = read_track(*table, scene);
        check_is_only(*table, track, tracks);
        tracks.push_back(std::move(track));
        out.seconds = std::max(out.seconds, tracks.back().keys.times.back());
    }
    out.pose = Posing(std::move(tracks), scene, origin);
    return out;
}

}  // namespace gw::scene
