//! Conversion of colours between bytes of pixels and linear light (IEC 61966-2-1).

/// The byte of a linear share, which is clamped to 0 to 1.
#[must_use]
pub fn byte(linear: f64) -> u8 {
    let share = if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * linear.powf(1.0 / 2.4) - 0.055
    };
    (255.0 * share).round() as u8
}

/// The linear share of a byte, from 0 to 1.
#[must_use]
pub fn linear(byte: u8) -> f64 {
    let share = f64::from(byte) / 255.0;
    if share <= 0.040_45 {
        share / 12.92
    } else {
        ((share + 0.055) / 1.055).powf(2.4)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_come_back() {
        assert!((0..=255).all(|byte| super::byte(linear(byte)) == byte));
        // Half the light is byte 188; byte 128 is 0.2159 of the light.
        assert_eq!(byte(0.5), 188);
        assert!((linear(128) - 0.215_861).abs() < 1e-6);
        assert_eq!([-1.0, 2.0, f64::NAN].map(byte), [0, 255, 0]);
    }
}
