#include "tests/pipeline/formats/exported_cameras.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>

namespace vantage::exported {
namespace {

/// Writes numbers with full precision.
class Text {
  public:
    Text() { out_ << std::setprecision(17); }
    template <class T>
    Text& operator<<(const T& v) {
        out_ << v;
        return *this;
    }
    /// Writes a matrix row by row.
    template <class M>
    Text& numbers(const M& m, const char* between) {
        for (Eigen::Index i = 0; i < m.rows(); ++i)
            for (Eigen::Index j = 0; j < m.cols(); ++j) out_ << (i + j > 0 ? between : "") << m(i, j);
        return *this;
    }
    std::string str() const { return out_.str(); }

  private:
    std::ostringstream out_;
};

Eigen::Matrix4d rigid(const Eigen::Matrix3d& R, const Eigen::Vector3d& t) {
    Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
    m.topLeftCorner<3, 3>() = R;
    m.topRightCorner<3, 1>() = t;
    return m;
}

double longer(const Photo& p) { return std::max(p.width, p.height); }

Text& row_of(Text& t, const Eigen::Matrix4d& m, int i) {
    return t << "[" << m(i, 0) << "," << m(i, 1) << "," << m(i, 2) << "," << m(i, 3) << "]";
}

}  // namespace

std::string colmap_cameras(const std::vector<Photo>& photos) {
    Text t;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const Photo& p = photos[i];
        t << i + 1 << " FULL_OPENCV " << p.width << " " << p.height << " " << p.fx << " " << p.fy << " "
          << p.cx << " " << p.cy << " " << p.k1 << " " << p.k2 << " " << p.p1 << " " << p.p2 << " " << p.k3
          << " 0 0 0\n";
    }
    return t.str();
}

std::string colmap_images(const std::vector<Photo>& photos) {
    Text t;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const Eigen::Quaterniond q(photos[i].R);
        t << i + 1 << " " << q.w() << " " << q.x() << " " << q.y() << " " << q.z() << " ";
        t.numbers(Eigen::Vector3d(-photos[i].R * photos[i].center), " ");
        t << " " << i + 1 << " " << photos[i].name << "\n\n";
    }
    return t.str();
}

std::string metashape(const std::vector<Photo>& photos, const Eigen::Matrix3d& chunk_R,
                      const Eigen::Vector3d& chunk_t, double chunk_scale) {
    Text t;
    t << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<document version=\"2.0.0\">\n  <chunk label=\"Chunk "
         "1\" "
         "enabled=\"true\">\n    <sensors>\n";
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const Photo& p = photos[i];
        t << "      <sensor id=\"" << i << "\" type=\"frame\"><resolution width=\"" << p.width
          << "\" height=\"" << p.height
          << "\"/>\n        <calibration type=\"frame\" class=\"initial\"><f>9</f></calibration>\n"
          << "        <calibration type=\"frame\" class=\"adjusted\"><resolution width=\"" << p.width
          << "\" height=\"" << p.height << "\"/>\n          <f>" << p.fy << "</f><cx>" << p.cx - p.width / 2.0
          << "</cx><cy>" << p.cy - p.height / 2.0 << "</cy><b1>" << p.fx - p.fy << "</b1><k1>" << p.k1
          << "</k1><k2>" << p.k2 << "</k2><k3>" << p.k3 << "</k3><p1>" << p.p2 << "</p1><p2>" << p.p1
          << "</p2></calibration></sensor>\n";
    }
    t << "    </sensors>\n    <cameras>\n      <camera id=\"99\" sensor_id=\"0\" label=\"lost\"/>\n";
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const Photo& p = photos[i];
        const Eigen::Vector3d in_chunk = chunk_R.transpose() * (p.center - chunk_t) / chunk_scale;
        const Eigen::Matrix3d to_chunk = chunk_R.transpose() * p.R.transpose();
        t << "      <camera id=\"" << i << "\" sensor_id=\"" << i << "\" label=\""
          << p.name.substr(0, p.name.rfind('.')) << "\">\n        <transform>";
        t.numbers(rigid(to_chunk, in_chunk), " ") << "</transform></camera>\n";
    }
    t << "    </cameras>\n    <reference>LOCAL_CS[\"Local Coordinates (m)\"]</reference>\n    <transform>\n"
         "      <rotation>";
    t.numbers(chunk_R, " ") << "</rotation>\n      <translation>";
    t.numbers(chunk_t, " ") << "</translation>\n      <scale>" << chunk_scale
                            << "</scale>\n    </transform>\n  </chunk>\n</document>\n";
    return t.str();
}

std::string realitycapture_xmp(const Photo& p, bool as_attributes) {
    const double s = longer(p);
    Text rotation, position, coefficients;
    rotation.numbers(p.R, " ");
    position.numbers(p.center, "\n        ");
    coefficients << p.k1 << " " << p.k2 << " " << p.k3 << " 0 " << p.p2 << " " << p.p1;
    Text t;
    t << "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n  <rdf:RDF "
         "xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n    <rdf:Description "
         "xmlns:xcr=\"http://www.capturingreality.com/ns/xcr/1.1#\" xcr:Version=\"3\" "
         "xcr:Coordinates=\"absolute\" xcr:DistortionModel=\"brown3t2\" xcr:FocalLength35mm=\""
      << p.fx * 36 / s << "\" xcr:Skew=\"0\" xcr:AspectRatio=\"" << p.fy / p.fx << "\" xcr:PrincipalPointU=\""
      << (p.cx - p.width / 2.0) / s << "\" xcr:PrincipalPointV=\"" << (p.cy - p.height / 2.0) / s << "\"";
    if (as_attributes)
        t << " xcr:Rotation=\"" << rotation.str() << "\" xcr:Position=\"" << position.str()
          << "\" xcr:DistortionCoeficients=\"" << coefficients.str() << "\"/>";
    else
        t << ">\n      <xcr:Rotation>" << rotation.str() << "</xcr:Rotation>\n      <xcr:Position>"
          << position.str() << "</xcr:Position>\n      <xcr:DistortionCoeficients>" << coefficients.str()
          << "</xcr:DistortionCoeficients>\n    </rdf:Description>";
    t << "\n  </rdf:RDF>\n</x:xmpmeta>\n";
    return t.str();
}

std::string realitycapture_csv(const std::vector<Photo>& photos) {
    const double degrees = 180 / std::numbers::pi;
    Text t;
    t << "#cameras " << photos.size() << "\n#name,x,y,alt,heading,pitch,roll,f,px,py,k1,k2,k3,k4,t1,t2\n";
    for (const Photo& p : photos) {
        // The axes of a camera that looks along -z with y up: Rz(-yaw) Rx(pitch) Ry(roll).
        const Eigen::Matrix3d m = p.R.transpose() * Eigen::Vector3d(1, -1, -1).asDiagonal();
        const double pitch = std::asin(m(2, 1)), yaw = std::atan2(m(0, 1), m(1, 1)),
                     roll = std::atan2(-m(2, 0), m(2, 2)), s = longer(p);
        t << p.name << "," << p.center.x() << "," << p.center.y() << "," << p.center.z() << ","
          << yaw * degrees << "," << pitch * degrees << "," << roll * degrees << "," << p.fx * 36 / s << ","
          << (p.cx - p.width / 2.0) / s << "," << (p.cy - p.height / 2.0) / s << "," << p.k1 << "," << p.k2
          << "," << p.k3 << ",0," << p.p2 << "," << p.p1 << "\n";
    }
    return t.str();
}

std::string meshroom(const std::vector<Photo>& photos) {
    Text t;
    t << "{\"version\": [\"1\", \"2\", \"11\"],\n\"views\": [";
    for (std::size_t i = 0; i < photos.size(); ++i)
        t << (i ? ",\n" : "") << "{\"viewId\": \"" << i << "\", \"poseId\": \"" << i + 50
          << "\", \"intrinsicId\": \"" << i + 7 << "\", \"path\": \"C:\\/scan\\/images\\/" << photos[i].name
          << "\", \"width\": \"" << photos[i].width << "\", \"height\": \"" << photos[i].height << "\"}";
    t << ",\n{\"viewId\": \"99\", \"poseId\": \"99\", \"intrinsicId\": \"7\", \"path\": \"lost.jpg\"}],\n"
         "\"intrinsics\": [";
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const Photo& p = photos[i];
        t << (i ? ",\n" : "") << "{\"intrinsicId\": \"" << i + 7 << "\", \"width\": \"" << p.width
          << "\", \"height\": \"" << p.height
          << "\", \"sensorWidth\": \"36\", \"sensorHeight\": \"24\", \"type\": \"pinhole\", \"focalLength\": "
             "\""
          << p.fy * 36 / p.width << "\", \"pixelRatio\": \"" << p.fy / p.fx << "\", \"principalPoint\": [\""
          << p.cx - p.width / 2.0 << "\", \"" << p.cy - p.height / 2.0
          << "\"], \"distortionType\": \"brown\", \"undistortionType\": \"none\", \"distortionParams\": [\""
          << p.k1 << "\", \"" << p.k2 << "\", \"" << p.k3 << "\", \"" << p.p1 << "\", \"" << p.p2 << "\"]}";
    }
    t << "],\n\"poses\": [";
    for (std::size_t i = 0; i < photos.size(); ++i) {
        t << (i ? ",\n" : "") << "{\"poseId\": \"" << i + 50
          << "\", \"pose\": {\"transform\": {\"rotation\": [\"";
        t.numbers(Eigen::Matrix3d(photos[i].R.transpose()), "\", \"") << "\"], \"center\": [\"";
        t.numbers(photos[i].center, "\", \"") << "\"]}, \"locked\": \"0\"}}";
    }
    t << "]}\n";
    return t.str();
}

std::string openmvg(const std::vector<Photo>& photos) {
    Text t;
    t << "{\"sfm_data_version\": \"0.3\", \"root_path\": \"/home/somebody/images\",\n\"views\": [";
    for (std::size_t i = 0; i < photos.size(); ++i)
        t << (i ? ",\n" : "") << "{\"key\": " << i
          << ", \"value\": {\"polymorphic_id\": 1073741824, \"ptr_wrapper\": {\"id\": " << 2147483649 + i
          << ", \"data\": {\"local_path\": \"\", \"filename\": \"" << photos[i].name
          << "\", \"width\": " << photos[i].width << ", \"height\": " << photos[i].height
          << ", \"id_view\": " << i << ", \"id_intrinsic\": " << i << ", \"id_pose\": " << i << "}}}}";
    t << "],\n\"intrinsics\": [";
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const Photo& p = photos[i];
        t << (i ? ",\n" : "") << "{\"key\": " << i << ", \"value\": {"
          << (i ? "\"polymorphic_id\": 1"
                : "\"polymorphic_id\": 2147483649, \"polymorphic_name\": \"pinhole_brown_t2\"")
          << ", \"ptr_wrapper\": {\"id\": " << 2147483700 + i << ", \"data\": {\"width\": " << p.width
          << ", \"height\": " << p.height << ", \"focal_length\": " << p.fx << ", \"principal_point\": ["
          << p.cx - 0.5 << ", " << p.cy - 0.5 << "], \"disto_t2\": [" << p.k1 << ", " << p.k2 << ", " << p.k3
          << ", " << p.p1 << ", " << p.p2 << "]}}}}";
    }
    t << "],\n\"extrinsics\": [";
    for (std::size_t i = 0; i < photos.size(); ++i) {
        t << (i ? ",\n" : "") << "{\"key\": " << i << ", \"value\": {\"rotation\": [";
        for (int r = 0; r < 3; ++r)
            (t << (r ? ", [" : "[")).numbers(Eigen::RowVector3d(photos[i].R.row(r)), ", ") << "]";
        (t << "], \"center\": [").numbers(photos[i].center, ", ") << "]}}";
    }
    t << "],\n\"structure\": [], \"control_points\": []}\n";
    return t.str();
}

std::string opensfm(const std::vector<Photo>& photos) {
    Text t;
    t << "[{\"cameras\": {";
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const Photo& p = photos[i];
        const double s = longer(p);
        t << (i ? ",\n" : "") << "\"v2 camera " << i
          << "\": {\"projection_type\": \"brown\", \"width\": " << p.width << ", \"height\": " << p.height
          << ", \"focal_x\": " << p.fx / s << ", \"focal_y\": " << p.fy / s
          << ", \"c_x\": " << (p.cx - p.width / 2.0) / s << ", \"c_y\": " << (p.cy - p.height / 2.0) / s
          << ", \"k1\": " << p.k1 << ", \"k2\": " << p.k2 << ", \"p1\": " << p.p1 << ", \"p2\": " << p.p2
          << ", \"k3\": " << p.k3 << "}";
    }
    t << "},\n\"shots\": {";
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const Eigen::AngleAxisd turn(photos[i].R);
        t << (i ? ",\n" : "") << "\"" << photos[i].name << "\": {\"rotation\": [";
        t.numbers(Eigen::Vector3d(turn.angle() * turn.axis()), ", ") << "], \"translation\": [";
        t.numbers(Eigen::Vector3d(-photos[i].R * photos[i].center), ", ")
            << "], \"camera\": \"v2 camera " << i << "\", \"orientation\": 1}";
    }
    t << "},\n\"points\": {}},\n{\"cameras\": {}, \"shots\": {}, \"points\": {}}]\n";
    return t.str();
}

std::string transforms(const std::vector<Photo>& photos, const Eigen::Matrix3d& applied,
                       const Eigen::Vector3d& applied_t) {
    const Eigen::Matrix4d a = rigid(applied, applied_t);
    Text t;
    t << "{\"camera_model\": \"OPENCV\", \"applied_transform\": [";
    for (int i = 0; i < 3; ++i) row_of(t << (i ? "," : ""), a, i);
    t << "],\n\"frames\": [";
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const Photo& p = photos[i];
        const Eigen::Matrix3d gl = p.R.transpose() * Eigen::Vector3d(1, -1, -1).asDiagonal();
        const Eigen::Matrix4d m = a * rigid(gl, p.center);
        t << (i ? ",\n" : "") << "{\"file_path\": \"images/" << p.name << "\", \"w\": " << p.width
          << ", \"h\": " << p.height << ", \"fl_x\": " << p.fx << ", \"fl_y\": " << p.fy
          << ", \"cx\": " << p.cx << ", \"cy\": " << p.cy << ", \"k1\": " << p.k1 << ", \"k2\": " << p.k2
          << ", \"k3\": " << p.k3 << ", \"p1\": " << p.p1 << ", \"p2\": " << p.p2
          << ", \"transform_matrix\": [";
        for (int r = 0; r < 4; ++r) row_of(t << (r ? "," : ""), m, r);
        t << "]}";
    }
    t << "]}\n";
    return t.str();
}

std::string blocks_exchange(const std::vector<Photo>& photos) {
    Text t;
    t << "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<BlocksExchange "
         "version=\"3.2\">\n<Block><SRSId>2</SRSId>\n"
         "<Photogroups>\n";
    for (const Photo& p : photos) {
        t << "<Photogroup><ImageDimensions><Width>" << p.width << "</Width><Height>" << p.height
          << "</Height></ImageDimensions>\n<CameraModelType>Perspective</CameraModelType><FocalLength>"
          << p.fx * 13.2 / longer(p)
          << "</FocalLength><SensorSize>13.2</SensorSize>\n<CameraOrientation>XLeftYUp</CameraOrientation>"
          << "<PrincipalPoint><x>" << p.cx - 0.5 << "</x><y>" << p.cy - 0.5
          << "</y></PrincipalPoint><AspectRatio>" << p.fy / p.fx
          << "</AspectRatio><Skew>0</Skew>\n<Distortion><K1>" << p.k1 << "</K1><K2>" << p.k2 << "</K2><K3>"
          << p.k3 << "</K3><P1>" << p.p2 << "</P1><P2>" << p.p1
          << "</P2></Distortion>\n<Photo><ImagePath>D:/scan/" << p.name << "</ImagePath><Pose><Rotation>";
        const Eigen::Matrix3d m = Eigen::Vector3d(-1, -1, 1).asDiagonal() * p.R;
        for (int i = 0; i < 9; ++i)
            t << "<M_" << i / 3 << i % 3 << ">" << m(i / 3, i % 3) << "</M_" << i / 3 << i % 3 << ">";
        t << "</Rotation><Center><x>" << p.center.x() << "</x><y>" << p.center.y() << "</y><z>"
          << p.center.z()
          << "</z></Center>\n<Metadata><Center><x>-83</x><y>40</y><z>1</z></Center></Metadata></Pose></Photo>"
             "</Photogroup>\n";
    }
    t << "</Photogroups></Block></BlocksExchange>\n";
    return t.str();
}

}  // namespace vantage::exported
