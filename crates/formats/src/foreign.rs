//! Files of other programs that are not read, each with the way to one that is.
//!
//! The content identifies a file, its ending only where the content says nothing. Nothing is parsed.

use std::fmt;
use std::path::Path;

/// A kind of file that is not read.
#[derive(Debug, PartialEq, Eq)]
pub struct Foreign {
    /// What people call it.
    pub name: &'static str,
    /// How its cameras come here.
    pub way: Way,
    /// The file begins with one of these, after blanks.
    begins: &'static [&'static [u8]],
    /// One of these is near the beginning or the end.
    holds: &'static [&'static str],
    /// Its endings, which decide where the content says nothing.
    endings: &'static [&'static str],
}

/// How cameras come out of a file that is not read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// glTF, from the program that made it.
    Gltf,
    /// A list of poses, from the program that made it.
    Poses,
    /// A list of poses in metres; the file has degrees of longitude and latitude.
    Metres,
    /// Nuke's list of poses.
    Chan,
    /// COLMAP's model, by this command.
    Colmap(&'static str),
    /// The model that COLMAP makes of its database.
    Model,
    /// `transforms.json`, by this command, which takes cameras that were exported as XML.
    Transforms(&'static str),
    /// The poses of a recording, by a program that reads such logs.
    Log,
    /// None: it has points only.
    NoCameras,
    /// By unpacking it.
    Unpack,
    /// The metadata in the archive.
    Metadata,
}

impl fmt::Display for Way {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Gltf => "export glTF from the program that made it",
            Self::Poses => "export the poses, as TUM, CSV or transforms.json for example",
            Self::Metres => "write its poses in metres, as TUM for example",
            Self::Metadata => {
                "unpack its metadata, with \"unzip -p in.r3d metadata > metadata.json\""
            }
            Self::Chan => "export the camera as .chan from Nuke",
            Self::Colmap(command) => {
                return write!(f, "export a COLMAP model with \"{command}\", and name its folder");
            }
            Self::Model => {
                "they have no poses: name the folder of the model that \"colmap mapper\" makes of them"
            }
            Self::Transforms(command) => {
                return write!(
                    f,
                    "export the cameras as XML, and make transforms.json of them with \"{command}\""
                );
            }
            Self::Log => "extract the poses, as with \"evo_traj bag in.bag TOPIC --save_as_tum\"",
            Self::NoCameras => "they have points and no cameras",
            Self::Unpack => "unpack it",
        })
    }
}

/// Bytes that are searched at either end of a file.
const SEARCHED: usize = 64 << 10;

impl Foreign {
    /// What a file of this name is, if it is of a kind that is not read; a folder has no name.
    pub(super) fn of(name: Option<&Path>, bytes: &[u8]) -> Option<&'static Self> {
        let head = &bytes[..bytes.len().min(SEARCHED)];
        let tail = &bytes[bytes.len().saturating_sub(SEARCHED).max(head.len())..];
        let ending = name.and_then(Path::extension).unwrap_or_default();
        let shown = |kind: &&Self| kind.begins(head) || kind.is_in(head) || kind.is_in(tail);
        let named = |kind: &&Self| {
            let mut endings = kind.endings.iter();
            endings.any(|known| ending.eq_ignore_ascii_case(known))
        };
        let by_content = KINDS.iter().find(shown);
        let by_name = || KINDS.iter().find(named);
        by_content
            .or_else(by_name)
            .or_else(|| CONTAINERS.iter().find(shown))
    }

    fn begins(&self, bytes: &[u8]) -> bool {
        let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let text = text.trim_ascii_start();
        self.begins.iter().any(|begin| text.starts_with(begin))
    }

    fn is_in(&self, bytes: &[u8]) -> bool {
        self.holds.iter().any(|part| {
            let mut places = bytes.windows(part.len());
            places.any(|place| place == part.as_bytes())
        })
    }
}

const fn kind(
    name: &'static str,
    way: Way,
    begins: &'static [&'static [u8]],
    holds: &'static [&'static str],
    endings: &'static [&'static str],
) -> Foreign {
    Foreign {
        name,
        way,
        begins,
        holds,
        endings,
    }
}

/// The first that fits counts.
#[rustfmt::skip]
static KINDS: [Foreign; 44] = [
    // Programs of film and animation.
    kind("FBX", Way::Gltf, &[b"Kaydara FBX Binary", b"; FBX"], &["FBXHeaderExtension:"], &["fbx"]),
    kind("Alembic", Way::Gltf, &[b"Ogawa"], &[], &["abc"]),
    kind("Blender", Way::Gltf, &[b"BLENDER"], &[], &["blend"]),
    kind("Maya", Way::Gltf, &[b"//Maya ASCII", b"FOR4", b"FOR8"], &[], &["ma", "mb"]),
    kind("Cinema 4D", Way::Gltf, &[b"QC4DC4D6"], &[], &["c4d"]),
    kind("3ds Max", Way::Gltf, &[], &[], &["max"]),
    kind("Houdini", Way::Gltf, &[], &[], &["hip", "hiplc", "hipnc"]),
    kind("LightWave", Way::Gltf, &[b"LWSC"], &[], &["lws"]),
    kind("Unity", Way::Gltf, &[], &["tag:unity3d.com"], &[]),
    kind("Collada", Way::Gltf, &[], &["<COLLADA"], &["dae"]),
    kind("BVH", Way::Gltf, &[b"HIERARCHY"], &[], &["bvh"]),
    kind("VRML", Way::Gltf, &[b"#VRML"], &[], &["wrl"]),
    kind("X3D", Way::Gltf, &[b"#X3D"], &["<X3D"], &["x3d"]),
    kind("Nuke", Way::Chan, &[], &["set cut_paste_input", "window_layout_xml", "/Nuke"], &["nk"]),
    kind("After Effects project", Way::Poses, &[b"RIFX"], &["<AfterEffectsProject"], &["aep"]),
    kind("After Effects keyframe", Way::Poses, &[b"Adobe After Effects"], &[], &[]),
    kind("Earth Studio", Way::Poses, &[], &["\"cameraFrames\""], &["esp"]),
    kind("POV-Ray", Way::Poses, &[b"#version 3."], &["#include \"colors.inc\""], &["pov"]),
    kind("Mitsuba", Way::Poses, &[], &["<scene version="], &[]),
    // Programs of science.
    kind("ParaView camera", Way::Poses, &[], &["<PVCameraConfiguration"], &["pvcc"]),
    kind("ParaView state", Way::Poses, &[], &["<ServerManagerState"], &["pvsm"]),
    kind("ParaView trace", Way::Poses, &[], &["paraview.simple"], &[]),
    kind("MeshLab", Way::Poses, &[], &["MeshLabDocument", "MeshLabProject", "<VCGCamera"], &["mlp"]),
    kind("LAS", Way::NoCameras, &[b"LASF"], &[], &["las", "laz"]),
    kind("E57", Way::NoCameras, &[b"ASTM-E57"], &[], &["e57"]),
    // Recordings of robots.
    kind("ROS bag", Way::Log, &[b"#ROSBAG"], &[], &["bag"]),
    kind("ROS 2 bag", Way::Log, &[], &["CREATE TABLE topics", "CREATE TABLE messages"], &["db3"]),
    kind("MCAP", Way::Log, &[b"\x89MCAP"], &[], &["mcap"]),
    kind("ULog", Way::Poses, &[b"ULog\x01"], &[], &["ulg"]),
    // Cameras from pictures.
    kind("COLMAP database", Way::Model, &[], &["two_view_geometries"], &["db"]),
    kind("OpenSfM", Way::Colmap("opensfm export_colmap"), &[], &["\"shots\""], &[]),
    kind("OpenMVG", Way::Colmap("openMVG_main_openMVG2Colmap"), &[], &["\"sfm_data_version\""], &[]),
    kind("AliceVision", Way::Poses, &[], &["\"featuresFolders\""], &["sfm", "mg"]),
    kind("Metashape", Way::Transforms("ns-process-data metashape"), &[], &["<chunk ", "agisoft"], &["psx", "psz"]),
    kind("Record3D", Way::Metadata, &[], &[], &["r3d"]),
    kind("ContextCapture", Way::Poses, &[], &["<BlocksExchange"], &[]),
    kind("Bundler", Way::Poses, &[b"# Bundle file"], &[], &[]),
    kind("VisualSFM", Way::Poses, &[b"NVM_V3"], &[], &["nvm"]),
    // On the globe.
    kind("KML", Way::Metres, &[], &["<kml"], &["kml"]),
    kind("KMZ", Way::Metres, &[], &["doc.kml"], &["kmz"]),
    kind("GPX", Way::Metres, &[], &["<gpx"], &["gpx"]),
    kind("CZML", Way::Metres, &[], &["\"id\":\"document\"", "\"id\": \"document\""], &["czml"]),
    kind("NMEA", Way::Metres, &[b"$GP", b"$GN"], &[], &["nmea"]),
    kind("SRT", Way::Metres, &[], &[" --> 0"], &["srt"]),
];

/// What may contain anything: the ending says more.
#[rustfmt::skip]
static CONTAINERS: [Foreign; 5] = [
    kind("SQLite", Way::Poses, &[b"SQLite format 3\0"], &[], &[]),
    kind("HDF5", Way::Poses, &[b"\x89HDF\r\n"], &[], &[]),
    kind("ZIP", Way::Unpack, &[b"PK\x03\x04"], &[], &[]),
    kind("gzip", Way::Unpack, &[b"\x1f\x8b"], &[], &[]),
    kind("Zstandard", Way::Unpack, &[b"\x28\xb5\x2f\xfd"], &[], &[]),
];
