// Gets cloth apart that has passed through itself, or through other cloth.
#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

#include "bullet/cloth_contact/crossings.h"
#include "bullet/small_steps/contact_search.h"
#include "bullet/small_steps/meeting_cloth.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Which of the points of lines belong to one line, and on which of its two sheets the edge is.
class ContourLines {
  public:
    void clear(std::size_t points);
    // Two points are of one line. @param areAlike  whether their edges are on the same sheet
    void join(std::size_t one, std::size_t other, bool areAlike);
    // The first point of a line, and whether the edges of both are on the same sheet.
    std::pair<std::size_t, bool> firstOf(std::size_t point) const;

  private:
    std::vector<std::size_t> before_;
    std::vector<char> isAlike_;
};

// Which side of a face a node should be on is unknown where cloth crosses, but the line along which it does has to
// become shorter until it is gone: cloth on both sides of it is moved as the line as a whole shrinks fastest (Volino and
// Magnenat-Thalmann, "Resolving surface collisions through intersection contour minimization", 2006). Crossings are
// found once a substep, and nothing is kept from one to the next but for how long cloth has crossed. The cloth is moved without velocity and no faster than
// a limit, so that this adds hardly any energy. Contacts that would keep a crossing as it is are left out.
class Untangler {
  public:
    // To be called at the start of a substep.
    void clear();
    // Finds where a pair crosses. What has crossed for too long is left as it is, so that cloth that cannot get apart
    // comes to rest. @pre the trees are where the nodes are  @return whether it crosses
    bool find(const ClothPair& pair, const MeetingCloth& one, const MeetingCloth& other);
    // Leaves out the contacts of a pair where it crosses.
    void leaveOut(ClothPair& pair, const MeetingCloth& one, const MeetingCloth& other) const;
    // Moves the cloth, in a small step, s.
    void pull(double smallStep);

  private:
    // A cloth of a pair.
    struct Side {
        const MeetingCloth* cloth;
        std::vector<Eigen::Vector3f> velocities;  // with which nodes are moved, m/s
        std::vector<char> crosses;                // whether a node is of an edge or a face that crosses
    };
    // Two cloths that cross; of a cloth that crosses itself the second is not used.
    struct Tangle {
        const MeetingCloth* one;
        const MeetingCloth* other;
        Side sides[2];
    };
    // An edge and a face.
    struct EdgeAndFace {
        int side;  // of the edge
        std::array<int, 2> ends;
        int faceSide;
        int face;  // in the order of its tree
        int pair;  // index of the pair of faces that cross, with one at the edge: there the line goes on
        bool isOfFirst;  // whether the edge is of the first of these
    };
    // An edge through a face: a point of the line along which cloth crosses.
    struct Passage {
        EdgeAndFace of;
        EdgeThroughFace at;
        Eigen::Vector3d shrinks;  // how the edge is to move along the face so that the line becomes shorter
    };

    Tangle& newTangle(const MeetingCloth& one, const MeetingCloth& other);
    void addPassages(const Tangle& tangle, const CrossingPair& pair, int index);
    void addPassage(const FaceCorners& ofEdge, const FaceCorners& through, std::size_t edge, EdgeAndFace of);
    void mergePassages();
    void moveLinesAsOne();
    void moveApart(Tangle& tangle, const Passage& passage, float speed) const;
    static bool holdsCrossing(const Tangle& tangle, const PairContact& contact);

    std::vector<Tangle> tangles_;
    std::size_t count_ = 0;  // in use; the others keep the capacity of their arrays
    Crossings crossings_;
    std::vector<Passage> passages_;
    // A point of a line in a pair of faces.
    struct OnLine {
        int pair;
        std::size_t passage;
        bool isOfFirst;
    };
    std::vector<OnLine> lines_;
    ContourLines contours_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
