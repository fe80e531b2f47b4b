namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>A convex part of a fluid: what lies between two upright lines, above a level one and on one side of a surface.</summary>
internal readonly struct FluidPart
{
    /// <param name="left">Least x.</param>
    /// <param name="right">Largest x.</param>
    /// <param name="bottom">Largest y.</param>
    /// <param name="surface">The surface; the fluid is at its positive side, which of one that runs to the right is greater y.</param>
    public FluidPart(double left, double right, double bottom, in OutlineEdge surface)
    {
        Left = left;
        Right = right;
        Bottom = bottom;
        Surface = surface;
    }

    public double Left { get; }

    public double Right { get; }

    public double Bottom { get; }

    public OutlineEdge Surface { get; }
}

/// <summary>A fluid whose bounds are straight: what is in it can be cut out exactly. In the world.</summary>
internal interface IStraightFluid
{
    /// <summary>The parts that a range of x may meet, from <paramref name="first"/> to before <paramref name="end"/>.</summary>
    void PartsWithin(double minX, double maxX, out int first, out int end);

    FluidPart Part(int index);
}
