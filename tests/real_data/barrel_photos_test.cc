#include "attention/find_target.h"
#include "attention/learn_color_model.h"
#include "tests/real_data/real_data.h"

namespace geon {
namespace {

using attention::ColorModel;
using attention::TargetSighting;

// Photos of one red barrel in clutter, 2 to 10 m away, with hand-made masks.
class BarrelPhotosTest : public RealDataTest {
 protected:
  struct Photo {
    std::string image;
    std::string mask;
  };
  std::vector<Photo> Photos() const {
    std::vector<Photo> photos;
    for (const auto& row : ReadCsv("photos/redbarrel.csv")) {
      photos.push_back({"photos/redbarrel/" + row[0], "photos/redbarrel/" + row[1]});
    }
    return photos;
  }
  // In how many photos the found target's centre lies on the barrel.
  int Hits(const ColorModel& model, const std::vector<Photo>& photos) const {
    int hits = 0;
    for (const Photo& photo : photos) {
      const sensor::Image image = Load(photo.image);
      const TargetSighting sighting = attention::FindTarget(image, model);
      if (!sighting.target) continue;
      const auto u = static_cast<size_t>(sighting.target->center_px.x() + 0.5);
      const auto v = static_cast<size_t>(sighting.target->center_px.y() + 0.5);
      hits += LoadMask(photo.mask)[v * static_cast<size_t>(image.width_px) + u] > 0 ? 1 : 0;
    }
    return hits;
  }
};

TEST_F(BarrelPhotosTest, SuperRedFindsTheBarrelInFourOfFive) {
  const auto photos = Photos();
  ASSERT_GE(photos.size(), 20U);
  const int hits = Hits(*attention::NamedColorModel("super-red"), photos);
  RecordProperty("hits", hits);
  EXPECT_GE(5 * hits, 4 * static_cast<int>(photos.size())) << hits << " of " << photos.size();
}

TEST_F(BarrelPhotosTest, TaughtColorFindsTheBarrelInNineOfTenAndMoreOftenThanTheThesisLab) {
  const auto photos = Photos();
  // Every fifth photo teaches, the others examine.
  std::vector<attention::TeachingSample> lessons;
  std::vector<Photo> exam;
  for (size_t i = 0; i < photos.size(); ++i) {
    if (i % 5 == 0) {
      lessons.push_back({Load(photos[i].image), LoadMask(photos[i].mask)});
    } else {
      exam.push_back(photos[i]);
    }
  }
  const auto learned = attention::LearnColorModel(lessons, "barrel");
  ASSERT_TRUE(learned.ok()) << learned.message();
  const int taught = Hits(learned->model, exam);
  const int thesis = Hits(*attention::NamedColorModel("thesis-lab"), exam);
  RecordProperty("taught", taught);
  RecordProperty("thesis_lab", thesis);
  EXPECT_GE(10 * taught, 9 * static_cast<int>(exam.size())) << taught << " of " << exam.size();
  EXPECT_GT(taught, thesis);
}

}  // namespace
}  // namespace geon
