//! Texts of the panels of a node: what it has, and the diamonds of its keys.

use super::texts;

texts! {
    NodePanel {
        points_tab, points_tab_hint, node_tab, node_tab_hint, first_of, parent, parent_name,
        no_parent, parent_hint, aim, aim_name, no_aim, aim_hint, aim_weight, aim_weight_hint,
        visible, visible_hint, place, position, position_hint, rotation, rotation_hint, yaw, pitch,
        roll, scale, scale_hint, pivot, pivot_hint, zoom, zoom_hint, camera_roll, camera_roll_hint,
        near, near_hint, far, far_hint, directional, directional_hint, point, point_hint, spot,
        spot_hint, colour, colour_hint, red, green, blue, intensity, intensity_hint, cone,
        cone_hint, inner, outer, mesh, mesh_points, mesh_missing, find_mesh, find, find_hint, load,
        load_mesh_hint, reload, reload_hint, mesh_gone, no_mesh_file, mesh_title, shape_title,
        shapes, add_shape, add_shape_hint, weight, weights, weight_hint, remove_shape, deformations,
        add_deformation, add_deformation_hint, choose_box_hint, box_low, box_high, box_hint,
        box_of_mesh, box_of_mesh_of, box_of_mesh_hint, bulge, axis, bend_axis_hint, axis_hint,
        earlier, later, remove_deformation, angle, middle_width, first_width, last_width,
        first_angle, last_angle, lattice, parameter_hint, values, value_hint, motion, none,
        none_hint, by_keys, by_keys_hint, by_path, by_path_hint, start, start_hint, pinned_start,
        beyond, beyond_name, beyond_hint, hold, repeat, pingpong, path_to_keys, path_to_keys_hint,
        few_keys, few_keys_hint, became_few_keys, nearness, nearness_hint, nearness_angle,
        nearness_angle_hint, keys_to_path, became_keys, rests, key_of, key_no_track, key_not_here,
        key_here, by_its_path, more_than_half, turned_too_far, set_keys, keys_set, keys_are_there,
    }
}

impl NodePanel {
    /// What a number of a deformation is called.
    pub(crate) fn parameter<'a>(&self, name: &'a str) -> &'a str {
        match name {
            "angle" => self.angle,
            "a" => self.middle_width,
            "r0" => self.first_width,
            "r1" => self.last_width,
            "phi_min" => self.first_angle,
            "phi_max" => self.last_angle,
            "points" => self.lattice,
            other => other,
        }
    }
}
