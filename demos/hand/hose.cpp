#include "hand/hose.h"

#include <algorithm>

namespace drench::demo {

// The water for one sheet.
struct Hose::Stream {
    explicit Stream(WetCloth& itsCloth)
        : cloth(&itsCloth),
          account(&itsCloth.account("hose")),
          spray(Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(), 0) {}

    const WetCloth* cloth;
    Supply* account;  // in the sheet's water time
    Spray spray;
    double due = 0;  // s of spraying still to do
};

// Runs as a source, because only a source gets the state of the sheet at the start of a step.
class Hose::StreamSource final : public Source {
  public:
    explicit StreamSource(std::shared_ptr<Stream> stream) : stream_(std::move(stream)) {}

    std::string name() const override { return "hose"; }
    void supply(const SheetPose& sheet, double, Supply&) override {
        stream_->spray.supply(sheet, stream_->due, *stream_->account);
        stream_->due = 0;
    }

  private:
    std::shared_ptr<Stream> stream_;
};

Hose::Stream& Hose::streamTo(WetCloth& cloth) {
    streams_.erase(std::remove_if(streams_.begin(), streams_.end(),
                                  [](const std::weak_ptr<Stream>& stream) { return stream.expired(); }),
                   streams_.end());
    for (const std::weak_ptr<Stream>& each : streams_)
        if (const auto stream = each.lock(); stream->cloth == &cloth) return *stream;
    const auto stream = std::make_shared<Stream>(cloth);
    cloth.add(StreamSource(stream));
    streams_.push_back(stream);
    return *stream;
}

void Hose::spray(const std::vector<Graspable>& sheets, const Nozzle& nozzle, double frameTime) {
    for (const Graspable& sheet : sheets) {
        Stream& stream = streamTo(*sheet.cloth);
        stream.spray.origin = nozzle.position;
        stream.spray.direction = nozzle.direction;
        stream.spray.halfAngle = nozzle.halfAngle;
        stream.spray.rate = nozzle.rate;
        stream.spray.speed = nozzle.speed;
        stream.due = frameTime;
    }
}

}  // namespace drench::demo
