using System;
using System.Collections.Generic;

namespace Farseer.Accuracy;

/// <summary>Measures that several scenes share.</summary>
internal static class Metrics
{
    /// <summary>Largest depth over all pairs of convex pieces of different bodies, static pairs left out; 0 = none.</summary>
    public static double Penetration(IReadOnlyList<Actor> actors)
    {
        var placed = new List<Placed>();
        for (int i = 0; i < actors.Count; i++)
        {
            foreach (Vec[] piece in actors[i].Pieces)
            {
                placed.Add(new Placed(i, actors[i].IsStatic, Outlines.Placed(piece, actors[i].Position, actors[i].Angle)));
            }
        }

        placed.Sort((a, b) => a.Left.CompareTo(b.Left));
        double deepest = 0;
        for (int i = 0; i < placed.Count; i++)
        {
            Placed a = placed[i];
            for (int j = i + 1; j < placed.Count && placed[j].Left < a.Right; j++)
            {
                Placed b = placed[j];
                bool counted = a.Owner != b.Owner && !(a.IsStatic && b.IsStatic);
                if (counted && a.Bottom < b.Top && b.Bottom < a.Top)
                {
                    deepest = Math.Max(deepest, Outlines.Depth(a.Outline, b.Outline));
                }
            }
        }

        return deepest;
    }

    /// <summary>Largest depth of one body in any of some others, 0 = none.</summary>
    public static double Penetration(IReadOnlyList<Actor> others, Actor one)
    {
        double deepest = 0;
        foreach (Actor other in others)
        {
            foreach (Vec[] a in other.Pieces)
            {
                foreach (Vec[] b in one.Pieces)
                {
                    deepest = Math.Max(
                        deepest,
                        Outlines.Depth(Outlines.Placed(a, other.Position, other.Angle), Outlines.Placed(b, one.Position, one.Angle)));
                }
            }
        }

        return deepest;
    }

    /// <summary>Runs for <paramref name="seconds"/>; the mean over the last second of sqrt(mean over dynamic bodies of |v|²).</summary>
    public static double RunForRmsSpeed(Rig rig, double seconds, Action? afterStep = null)
    {
        int steps = rig.StepsIn(seconds);
        int first = steps - rig.StepsIn(1);
        double sum = 0;
        int count = 0;
        for (int i = 0; i < steps; i++)
        {
            rig.Step();
            afterStep?.Invoke();
            if (i >= first)
            {
                sum += RmsSpeed(rig.Actors);
                count++;
            }
        }

        return sum / count;
    }

    public static double LargestDisplacement(IReadOnlyList<Actor> actors)
    {
        double largest = 0;
        foreach (Actor actor in actors)
        {
            largest = Math.Max(largest, actor.Displacement.Length);
        }

        return largest;
    }

    private static double RmsSpeed(IReadOnlyList<Actor> actors)
    {
        double sum = 0;
        int count = 0;
        foreach (Actor actor in actors)
        {
            if (!actor.IsStatic)
            {
                sum += Vec.Dot(actor.Velocity, actor.Velocity);
                count++;
            }
        }

        return Math.Sqrt(sum / count);
    }

    private sealed class Placed
    {
        public Placed(int owner, bool isStatic, Vec[] outline)
        {
            Owner = owner;
            IsStatic = isStatic;
            Outline = outline;
            Left = Bottom = double.MaxValue;
            Right = Top = double.MinValue;
            foreach (Vec point in outline)
            {
                Left = Math.Min(Left, point.X);
                Right = Math.Max(Right, point.X);
                Bottom = Math.Min(Bottom, point.Y);
                Top = Math.Max(Top, point.Y);
            }
        }

        public int Owner { get; }

        public bool IsStatic { get; }

        public Vec[] Outline { get; }

        public double Left { get; }

        public double Right { get; }

        public double Bottom { get; }

        public double Top { get; }
    }
}
