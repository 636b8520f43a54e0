//! Path data: the attribute `d` as chains of lines, curves and arcs.
//!
//! All commands of the specification are read, absolute and relative, with repeated arguments and with numbers that touch.
//! After a fault nothing of that path is read, as browsers do; what came before it is drawn.

use super::numbers::Scanner;
use super::outline::{Chain, Piece, arc};
use crate::geometry::DVec2;

/// The chains of a path.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct PathData {
    pub(super) chains: Vec<Chain>,
    /// Whether the data was cut off at a fault.
    pub(super) faulty: bool,
}

/// Reads path data.
pub(super) fn read(data: &str) -> PathData {
    let mut reader = Reader {
        scanner: Scanner::new(data),
        chains: Vec::new(),
        chain: None,
        at: DVec2::ZERO,
        start: DVec2::ZERO,
        cubic: None,
        quadratic: None,
    };
    let faulty = reader.run().is_none();
    reader.finish();
    PathData { chains: reader.chains, faulty }
}

struct Reader<'a> {
    scanner: Scanner<'a>,
    chains: Vec<Chain>,
    chain: Option<Chain>,
    /// The current point.
    at: DVec2,
    /// Start of the current chain, to which a closing command returns.
    start: DVec2,
    /// The last control point, if the command before was a cubic curve.
    cubic: Option<DVec2>,
    /// The last control point, if the command before was a quadratic curve.
    quadratic: Option<DVec2>,
}

impl Reader<'_> {
    /// Reads all commands; `None` at a fault.
    fn run(&mut self) -> Option<()> {
        self.scanner.skip_blanks();
        if self.scanner.peek().is_none() || self.scanner.rest() == b"none" {
            return Some(());
        }
        let mut command = self.command()?;
        if !matches!(command, b'M' | b'm') {
            return None;
        }
        loop {
            self.execute(command)?;
            // More coordinates after a move are lines.
            let repeated = match command {
                b'M' => b'L',
                b'm' => b'l',
                other => other,
            };
            let before = self.scanner;
            self.scanner.skip_separator();
            match self.scanner.peek() {
                None => {
                    return (self.scanner.rest().len() == before.rest().len() || !has_comma(before))
                        .then_some(());
                }
                Some(b'0'..=b'9' | b'.' | b'-' | b'+') if !matches!(command, b'Z' | b'z') => {
                    command = repeated
                }
                Some(_) => command = self.command()?,
            }
        }
    }

    fn command(&mut self) -> Option<u8> {
        self.scanner.skip_blanks();
        let command = self.scanner.peek()?;
        self.scanner.advance();
        command.is_ascii_alphabetic().then_some(command)
    }

    fn execute(&mut self, command: u8) -> Option<()> {
        let relative = command.is_ascii_lowercase();
        let base = if relative { self.at } else { DVec2::ZERO };
        let (cubic, quadratic) = (self.cubic.take(), self.quadratic.take());
        match command.to_ascii_uppercase() {
            b'M' => {
                let to = base + self.point()?;
                self.finish();
                (self.at, self.start) = (to, to);
                self.chain = Some(Chain::new(to));
            }
            b'L' => {
                let to = base + self.point()?;
                self.push(Piece::Line(to), to);
            }
            b'H' => {
                let to = DVec2::new(base.x + self.scanner.next_number()?, self.at.y);
                self.push(Piece::Line(to), to);
            }
            b'V' => {
                let to = DVec2::new(self.at.x, base.y + self.scanner.next_number()?);
                self.push(Piece::Line(to), to);
            }
            b'C' => {
                let (a, b, to) = (base + self.point()?, base + self.point()?, base + self.point()?);
                self.curve(a, b, to);
            }
            b'S' => {
                let a = cubic.map_or(self.at, |c| self.at * 2.0 - c);
                let (b, to) = (base + self.point()?, base + self.point()?);
                self.curve(a, b, to);
            }
            b'Q' => {
                let (control, to) = (base + self.point()?, base + self.point()?);
                self.quadratic(control, to);
            }
            b'T' => {
                let control = quadratic.map_or(self.at, |c| self.at * 2.0 - c);
                let to = base + self.point()?;
                self.quadratic(control, to);
            }
            b'A' => {
                let radii = self.point()?;
                let rotation = self.scanner.next_number()?.to_radians();
                let (large, sweep) = (self.scanner.next_flag()?, self.scanner.next_flag()?);
                let to = base + self.point()?;
                match arc(self.at, to, radii, rotation, large, sweep) {
                    Some(ellipse) => self.push(Piece::Arc(ellipse, to), to),
                    None => self.push(Piece::Line(to), to),
                }
            }
            b'Z' => {
                if let Some(mut chain) = self.chain.take() {
                    chain.closed = true;
                    self.chains.push(chain);
                }
                self.at = self.start;
            }
            _ => return None,
        }
        Some(())
    }

    fn point(&mut self) -> Option<DVec2> {
        Some(DVec2::new(self.scanner.next_number()?, self.scanner.next_number()?))
    }

    fn curve(&mut self, a: DVec2, b: DVec2, to: DVec2) {
        self.push(Piece::Cubic(a, b, to), to);
        self.cubic = Some(b);
    }

    fn quadratic(&mut self, control: DVec2, to: DVec2) {
        self.push(Piece::Quadratic(control, to), to);
        self.quadratic = Some(control);
    }

    /// Adds a piece. After a closing command a new chain starts where the closed one started.
    fn push(&mut self, piece: Piece, to: DVec2) {
        self.chain.get_or_insert_with(|| Chain::new(self.start)).pieces.push(piece);
        self.at = to;
    }

    /// Ends the current chain. A move that nothing follows draws nothing.
    fn finish(&mut self) {
        self.chains.extend(self.chain.take().filter(|c| !c.pieces.is_empty()));
    }
}

fn has_comma(scanner: Scanner<'_>) -> bool {
    scanner.rest().contains(&b',')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ends(data: &str) -> Vec<Vec<[f64; 2]>> {
        let path = read(data);
        let end = |p: &Piece| match *p {
            Piece::Line(p) | Piece::Quadratic(_, p) | Piece::Cubic(_, _, p) | Piece::Arc(_, p) => {
                p.to_array()
            }
        };
        path.chains
            .iter()
            .map(|c| [vec![c.start.to_array()], c.pieces.iter().map(end).collect()].concat())
            .collect()
    }

    #[test]
    fn absolute_and_relative_commands() {
        let absolute =
            "M10 20 L30 20 H40 V50 C40 60 30 60 30 50 S20 40 20 50 Q10 60 10 50 T10 30 A5 5 0 0 1 10 20 Z";
        let relative =
            "m10 20 l20 0 h10 v30 c0 10-10 10-10 0 s-10-10-10 0 q-10 10-10 0 t0-20 a5 5 0 01 0-10 z";
        assert_eq!(ends(absolute), ends(relative));
        assert!(read(absolute).chains[0].closed && !read(absolute).faulty);
        let cubic = &read(absolute).chains[0].pieces[4];
        assert_eq!(
            *cubic,
            Piece::Cubic(DVec2::new(30.0, 40.0), DVec2::new(20.0, 40.0), DVec2::new(20.0, 50.0))
        );
        let quadratic = &read(absolute).chains[0].pieces[6];
        assert_eq!(*quadratic, Piece::Quadratic(DVec2::new(10.0, 40.0), DVec2::new(10.0, 30.0)));
    }

    #[test]
    fn repeated_arguments_and_touching_numbers() {
        assert_eq!(ends("M0 0 10 0 10 10"), [[[0.0, 0.0], [10.0, 0.0], [10.0, 10.0]]]);
        assert_eq!(
            ends("m1 1 2 0 0 2z m5 0 1 1"),
            [vec![[1.0, 1.0], [3.0, 1.0], [3.0, 3.0]], vec![[6.0, 1.0], [7.0, 2.0]]]
        );
        assert_eq!(ends("M.5.5-1-1"), [[[0.5, 0.5], [-1.0, -1.0]]]);
        assert_eq!(ends("M0 0a1,1 0 0110,0"), [[[0.0, 0.0], [10.0, 0.0]]]);
    }

    #[test]
    fn after_closing_the_path_goes_on_from_its_start() {
        assert_eq!(
            ends("M1 2 h3 v4 z h-5"),
            [vec![[1.0, 2.0], [4.0, 2.0], [4.0, 6.0]], vec![[1.0, 2.0], [-4.0, 2.0]]]
        );
    }

    #[test]
    fn a_fault_ends_the_path_and_keeps_what_came_before() {
        let path = read("M0 0 L10 0 L20 X 5");
        assert!(path.faulty);
        assert_eq!(path.chains[0].pieces, [Piece::Line(DVec2::new(10.0, 0.0))]);
        assert!(read("L 1 1").faulty && read("L 1 1").chains.is_empty());
        assert!(read("M0 0 A1 1 0 2 0 5 5").faulty);
        assert!(!read("").faulty && !read("none").faulty && !read("M1 1").faulty);
    }
}
