#include "stage/stage_source.h"

#include <algorithm>
#include <stdexcept>

namespace drench::demo {

namespace {

// Nodes of a sheet within the circle of a soak.
std::vector<std::size_t> nodesWithin(const SoakDescription& soak, const SceneCloth& sheet) {
    std::vector<std::size_t> nodes;
    for (int n = 0; n < sheet.body().m_nodes.size(); ++n)
        if ((sheet.flatPosition(n) - soak.centre).norm() <= soak.radius) nodes.push_back(std::size_t(n));
    return nodes;
}

// Adds a source to a sheet.
struct Begin {
    SceneCloth& sheet;
    const std::string& name;

    Source& operator()(const SprayDescription& spray) const {
        return sheet.wet().add(Spray(spray.origin, spray.direction, spray.rate));
    }
    Source& operator()(const PoolDescription& pool) const { return sheet.wet().add(Pool(pool.level)); }
    Source& operator()(const SoakDescription& soak) const {
        const std::vector<std::size_t> nodes = nodesWithin(soak, sheet);
        if (nodes.empty())
            throw std::invalid_argument("the source '" + name + "' reaches no node of the sheet '" +
                                        sheet.name() + "'; give it a larger radius");
        double area = 0;
        for (const std::size_t node : nodes) area += sheet.wet().moisture().area(node);
        return sheet.wet().add(TimedSoak(nodes, soak.massPerArea * area, soak.duration));
    }
    Source& operator()(const BrushDescription& brush) const {
        return sheet.wet().add(Brush(brush.centre, brush.radius, brush.rate));
    }
};

// Applies the settings of a description to an active source.
struct Refresh {
    Source& source;

    void operator()(const SprayDescription& wanted) const {
        Spray& spray = static_cast<Spray&>(source);
        spray.origin = wanted.origin;
        spray.direction = wanted.direction;
        spray.halfAngle = wanted.halfAngle;
        spray.rate = wanted.rate;
        spray.speed = wanted.speed;
    }
    void operator()(const PoolDescription& wanted) const {
        Pool& pool = static_cast<Pool&>(source);
        pool.level = wanted.level;
        pool.from = wanted.from;
        pool.to = wanted.to;
    }
    void operator()(const SoakDescription&) const {}
    void operator()(const BrushDescription& wanted) const {
        Brush& brush = static_cast<Brush&>(source);
        brush.centre = wanted.centre;
        brush.radius = wanted.radius;
        brush.rate = wanted.rate;
    }
};

SceneCloth* sheetNamed(const std::string& name, const std::vector<std::unique_ptr<SceneCloth>>& sheets) {
    for (const auto& sheet : sheets)
        if (sheet->name() == name) return sheet.get();
    return nullptr;
}

}  // namespace

StageSource::StageSource(const SourceDescription& description,
                         const std::vector<std::unique_ptr<SceneCloth>>& sheets)
    : description_(description) {
    if (description_.sheets.empty())
        for (const auto& sheet : sheets) works_.push_back({sheet.get(), nullptr});
    for (const std::string& name : description_.sheets) {
        SceneCloth* const sheet = sheetNamed(name, sheets);
        if (!sheet)
            throw std::invalid_argument("the source '" + description_.name + "' names the sheet '" + name +
                                        "', which is not there");
        works_.push_back({sheet, nullptr});
    }
}

bool StageSource::isDue(double time, double frameTime) const {
    return time > description_.from - frameTime / 2 && time < description_.until - frameTime / 2;
}

void StageSource::prepare(double time, double frameTime) {
    const bool due = isDue(time, frameTime);
    for (Work& work : works_) {
        if (due && !work.source)
            work.source = &std::visit(Begin{*work.sheet, description_.name}, description_.water);
        if (!due && work.source) {
            work.sheet->wet().remove(*work.source);
            work.source = nullptr;
        }
        if (work.source) std::visit(Refresh{*work.source}, description_.water);
    }
}

std::optional<Nozzle> StageSource::nozzle(double time, double frameTime) const {
    const auto* const spray = std::get_if<SprayDescription>(&description_.water);
    const bool flows = spray && spray->seen && spray->rate > 0 && spray->speed > 0;
    if (!flows || !isDue(time, frameTime)) return std::nullopt;
    return Nozzle{spray->origin, spray->direction, spray->halfAngle, spray->speed, spray->rate};
}

std::optional<SourceDescription> StageSource::describe(double time) const {
    SourceDescription now = description_;
    auto* const soak = std::get_if<SoakDescription>(&now.water);
    if (!soak || time <= now.from || works_.empty()) return now;
    // In water time, which may run faster.
    const double whole = soak->duration / std::max(works_.front().sheet->waterSpeed(), 1e-9);
    const double left = now.from + whole - time;
    if (!(left > 0)) return std::nullopt;
    soak->massPerArea *= left / whole;
    soak->duration *= left / whole;
    now.from = time;
    return now;
}

}  // namespace drench::demo
