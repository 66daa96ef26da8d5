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
  static constexpr size_t kFolds = 5;

  void SetUp() override {
    RealDataTest::SetUp();
    if (IsSkipped()) return;
    for (const auto& row : ReadCsv("photos/redbarrel.csv")) {
      photos_.push_back(
          {Load("photos/redbarrel/" + row[0]), LoadMask("photos/redbarrel/" + row[1])});
    }
    ASSERT_EQ(photos_.size(), 25U);
  }

  struct Score {
    int hits = 0;          // photos in which the found target's centre lies on the barrel
    double iou_sum_1 = 0;  // of found and true mask
  };
  void Examine(const attention::TeachingSample& photo, const ColorModel& model,
               Score* score) const {
    const TargetSighting sighting = attention::FindTarget(photo.image, model);
    if (!sighting.target) return;
    const auto u = static_cast<size_t>(sighting.target->center_px.x() + 0.5);
    const auto v = static_cast<size_t>(sighting.target->center_px.y() + 0.5);
    if (photo.is_target[v * static_cast<size_t>(photo.image.width_px) + u] != 0) ++score->hits;
    double both = 0.0, either = 0.0;
    for (size_t i = 0; i < sighting.mask.size(); ++i) {
      both += sighting.mask[i] != 0 && photo.is_target[i] != 0;
      either += sighting.mask[i] != 0 || photo.is_target[i] != 0;
    }
    score->iou_sum_1 += both / either;
  }
  // Taught on every photo but each fifth, examined on those.
  Score CrossValidate(const std::vector<attention::TeachingSample>& lessons) const {
    Score score;
    for (size_t fold = 0; fold < kFolds; ++fold) {
      std::vector<attention::TeachingSample> taught;
      for (size_t i = 0; i < lessons.size(); ++i) {
        if (i % kFolds != fold) taught.push_back(lessons[i]);
      }
      const auto learned = attention::LearnColorModel(taught, "barrel");
      EXPECT_TRUE(learned.ok()) << learned.message();
      for (size_t i = fold; i < photos_.size(); i += kFolds) {
        Examine(photos_[i], learned->model, &score);
      }
    }
    RecordProperty("hits", score.hits);
    RecordProperty("mean_iou_percent", static_cast<int>(100.0 * score.iou_sum_1 / 25.0));
    return score;
  }

  std::vector<attention::TeachingSample> photos_;  // with the true masks
};

// The thesis's recipe, for comparison.
TEST_F(BarrelPhotosTest, SuperRedFindsTheBarrelInFourOfFive) {
  Score score;
  for (const auto& photo : photos_) {
    Examine(photo, *attention::NamedColorModel("super-red"), &score);
  }
  EXPECT_GE(score.hits, 20) << "of 25";
}

TEST_F(BarrelPhotosTest, ColorTaughtByMasksFindsTheBarrelInOtherPhotos) {
  const Score score = CrossValidate(photos_);
  EXPECT_GE(score.hits, 23) << "of 25";
  EXPECT_GE(score.iou_sum_1 / 25.0, 0.78);
}

TEST_F(BarrelPhotosTest, ColorTaughtByBoxesIsHardlyWorse) {
  std::vector<attention::TeachingSample> boxed = photos_;
  for (attention::TeachingSample& photo : boxed) {
    cv::Mat1b mask(photo.image.height_px, photo.image.width_px, photo.is_target.data());
    std::vector<cv::Point> marked;
    cv::findNonZero(mask, marked);
    cv::Point first = marked.front(), last = marked.front();
    for (const cv::Point& point : marked) {
      first = {std::min(first.x, point.x), std::min(first.y, point.y)};
      last = {std::max(last.x, point.x), std::max(last.y, point.y)};
    }
    mask(cv::Rect(first, last + cv::Point(1, 1))) = 255;
  }
  const Score score = CrossValidate(boxed);
  EXPECT_GE(score.hits, 23) << "of 25";
  EXPECT_GE(score.iou_sum_1 / 25.0, 0.78);
}

}  // namespace
}  // namespace geon
