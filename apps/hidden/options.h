// What gw hidden, play, fragments, quiz and grade share: the options of a scene's polygons and of
// the form of the answer.
#pragma once

#include "apps/picture/picture_options.h"
#include "hiddensurface/interface/steps.h"
#include "image/output/output_set.h"

namespace gw::apps {

enum class Form { Text, Json, Csv };

/// Adds --json and, if the answer is a table, --csv.
void add_form_options(CLI::App& command, Form& form, bool is_table);

/// Adds SCENE and the options of size, camera, profile and machine.
void add_polygon_options(CLI::App& command, PictureOptions& picture);
/// The options' values, before any is given.
inline PictureOptions polygon_options() { return {{.size = {320, 240}}}; }

struct HiddenOptions {
    PictureOptions picture = polygon_options();
    /// One, or two side by side, all of surfaces or of lines. Empty: all hidden-surface algorithms.
    std::vector<std::string> algorithms;
    double limit = 300;  ///< the longest estimated time of a run in seconds; 0: none
    std::filesystem::path steps, compare;
    hiddensurface::Level level = hiddensurface::Level::Polygon;
    Form form = Form::Text;
};

/// Creates the folders of steps and comparison, so that a bad name is found early.
void make_folders(image::OutputSet& output, const HiddenOptions& options);
/// The folder of an algorithm's steps: of two, each has its own.
std::filesystem::path folder_of_steps(const HiddenOptions& options, const std::string& algorithm);

/// Draws with hidden-line algorithms, with counts and steps (lines.cpp).
int hidden_lines(const HiddenOptions& options, Session& session);

}  // namespace gw::apps
