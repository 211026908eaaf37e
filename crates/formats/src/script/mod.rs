//! Scripts that make a flight in another program: Blender, ParaView, VTK.
//!
//! A script is a separate file beside this one, with its flight between two lines: JSON in a raw
//! string, a frame a line. Texts of the document are ASCII in it without quotes and backslashes,
//! so that nothing in them can end the string: they are data, never code. What reads a script takes
//! these lines alone; nothing is run.

mod blender;
mod data;
mod objects;
mod paraview;
mod vtk;

pub(crate) use blender::BLENDER;
pub(crate) use paraview::PARAVIEW;
pub(crate) use vtk::VTK;
