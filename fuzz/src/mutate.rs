//! Changes of a text that mostly leave it TOML: values, keys, lines and tables
//! are exchanged, doubled, moved and left out. Half of all changes are the
//! fuzzer's own, which know nothing of that.

/// What the files of one kind are made of.
pub struct Words {
    /// Whole lines, headers among them.
    pub lines: &'static [&'static str],
    /// Values that may stand behind an equals sign.
    pub values: &'static [&'static str],
}

/// Numbers at the edges of what is allowed, and beyond.
const NUMBERS: &[&str] = &[
    "0",
    "-0.0",
    "0.0",
    "1",
    "-1",
    "1.0",
    "-1.0",
    "0.5",
    "2",
    "9",
    "10",
    "11",
    "50",
    "99.9",
    "100",
    "100.0",
    "100.5",
    "180",
    "-180.0",
    "1e9",
    "-1e9",
    "1.0000001e9",
    "1e300",
    "-1e308",
    "1e999",
    "5e-324",
    "1e-300",
    "-2.5e-310",
    "1e-9",
    "1e-12",
    "0.1",
    "-0.6",
    "0.2",
    "0.8",
    "0.30000000000000004",
    "nan",
    "-inf",
    "inf",
    "1_000",
    "0x10",
    "0b1",
    "0o7",
    "2147483647",
    "-2147483648",
    "2147483648",
    "9223372036854775807",
    "9223372036854775808",
    "1000000",
    "1000001",
    "100000",
    "1e5",
    "0.999999999999999",
    "719.9999999",
    "1e15",
    "1e16",
];

/// A small generator: the fuzzer's seed decides everything.
struct Random(u64);

impl Random {
    fn below(&mut self, most: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let high = self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 33;
        high as usize % most.max(1)
    }

    fn of<'a, T: ?Sized>(&mut self, all: &[&'a T]) -> &'a T {
        all[self.below(all.len())]
    }
}

/// Changes `data`, of which `size` bytes are in use; gives the new size.
pub fn mutate(data: &mut [u8], size: usize, most: usize, seed: u32, words: &Words) -> usize {
    let mut random = Random(u64::from(seed) << 1 | 1);
    random.below(1);
    let Ok(text) = std::str::from_utf8(&data[..size]) else {
        return libfuzzer_sys::fuzzer_mutate(data, size, most);
    };
    if random.below(2) == 0 {
        return libfuzzer_sys::fuzzer_mutate(data, size, most);
    }
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    for _ in 0..=random.below(4) {
        change(&mut lines, words, &mut random);
    }
    let mut new = lines.join("\n");
    new.push('\n');
    if new.len() > most {
        return libfuzzer_sys::fuzzer_mutate(data, size, most);
    }
    data[..new.len()].copy_from_slice(new.as_bytes());
    new.len()
}

fn change(lines: &mut Vec<String>, words: &Words, random: &mut Random) {
    let at = random.below(lines.len());
    if lines.is_empty() {
        lines.push(random.of(words.lines).to_owned());
        return;
    }
    match random.below(12) {
        0 | 1 => lines.insert(
            random.below(lines.len() + 1),
            random.of(words.lines).to_owned(),
        ),
        2 => {
            lines.remove(at);
        }
        3 => lines.insert(at, lines[random.below(lines.len())].clone()),
        4 => {
            let other = random.below(lines.len());
            lines.swap(at, other);
        }
        // A whole table, doubled or left out.
        5 | 6 => {
            let heads: Vec<usize> = (0..lines.len())
                .filter(|&line| lines[line].starts_with('['))
                .collect();
            if heads.is_empty() {
                return;
            }
            let head = random.below(heads.len());
            let from = heads[head];
            let to = heads
                .get(head + 1 + random.below(2))
                .copied()
                .unwrap_or(lines.len());
            if random.below(3) == 0 {
                lines.drain(from..to);
            } else {
                let table = lines[from..to].to_vec();
                for _ in 0..=random.below(3) {
                    lines.splice(to..to, table.iter().cloned());
                }
            }
        }
        7 => {
            if let Some((key, _)) = lines[at].split_once('=') {
                lines[at] = format!("{key}= {}", random.of(words.values));
            }
        }
        8 => {
            if let Some((key, _)) = lines[at].split_once('=') {
                lines[at] = format!("{key}= {}", random.of(NUMBERS));
            }
        }
        _ => lines[at] = with_another_number(&lines[at], random),
    }
}

/// The line with one of its numbers exchanged.
fn with_another_number(line: &str, random: &mut Random) -> String {
    let of_number = |byte: u8| byte.is_ascii_digit() || b"+-._e".contains(&byte);
    let bytes = line.as_bytes();
    let mut numbers = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        let begin = at;
        while at < bytes.len() && of_number(bytes[at]) {
            at += 1;
        }
        if bytes[begin..at].iter().any(u8::is_ascii_digit) {
            numbers.push(begin..at);
        }
        at += 1;
    }
    if numbers.is_empty() {
        return line.to_owned();
    }
    let number = numbers[random.below(numbers.len())].clone();
    let new = match random.below(4) {
        // One that stands here already: equal places, equal views.
        0 => line[numbers[random.below(numbers.len())].clone()].to_owned(),
        1 => format!("{:?}", (random.below(2_000_001) as f64 - 1e6) / 1e6),
        _ => random.of(NUMBERS).to_owned(),
    };
    format!("{}{new}{}", &line[..number.start], &line[number.end..])
}
