// The growth study as plots, tables and fitted power laws. Does not measure.
#pragma once

#include "apps/study/growth.h"
#include "image/plot/plot.h"

namespace gw::study {

struct GrowthPlot {
    std::string name;  ///< of the file, without its extension
    std::string axis, value;
    bool lines = false;
    plot::Plot plot;
};
/// The same colour and line for an algorithm in every plot of surfaces, or of lines.
void add_styles(plot::Plot& plot, const Growth& growth, bool lines);

/// A plot for every axis and every value above 0, with all algorithms; surfaces and lines have plots
/// of their own.
std::vector<GrowthPlot> growth_plots(const Growth& growth);

/// value = factor axis^exponent, fitted to an algorithm's points above 0.
struct GrowthLaw {
    std::string axis, algorithm, value;
    bool lines = false;
    plot::PowerLaw law;
    std::size_t points = 0;
};
/// The laws of all series of three points or more.
std::vector<GrowthLaw> growth_laws(const Growth& growth);

/// "axis,algorithm,value,x,y": a row for every measured number.
std::string growth_csv(const Growth& growth);
/// "axis,algorithm,value,exponent,factor,points"
std::string laws_csv(const std::vector<GrowthLaw>& laws);

}  // namespace gw::study
