namespace Farseer.Engine.Contacts;

/// <summary>What the sides of the pairs of a bundle, or of two side by side, are, a bit for each lane.</summary>
internal struct PairBits
{
    public int Exists;

    /// <summary>Gives impulses: both colliders respond and at least one body can move.</summary>
    public int Solid;
    public int Heard;
    public int Boxes;
    public int Circles;

    /// <summary>Two hulls that lanes can do, boxes included.</summary>
    public int Hulls;

    /// <summary>Such a hull and a circle, and those whose circle is A.</summary>
    public int CircleHulls;
    public int CircleFirst;

    /// <summary>One of the sides is a box whose own axes are not those of its body.</summary>
    public int Tilted;
    public int NewBox;

    /// <summary>A body of the pair is fast.</summary>
    public int Fast;

    /// <summary>The bits of a bundle's lanes.</summary>
    public const int OneBundle = (1 << ContactBundle.Lanes) - 1;

    /// <summary>Of the bits of two bundles side by side those of one.</summary>
    public static int Of(int bits, int bundle) => (bits >> (bundle * ContactBundle.Lanes)) & OneBundle;
}

/// <summary>What the manifolds of such pairs say, a bit for each lane.</summary>
internal struct TouchBits
{
    public int Touching;

    /// <summary>Touched in the step before.</summary>
    public int Touched;

    /// <summary>Has points.</summary>
    public int Hit;

    /// <summary>The flags of an unheard pair are what they were.</summary>
    public int Same;

    /// <summary>Touches and would sink in by more than <see cref="PairStage.BlowShare"/>: it will be struck.</summary>
    public int Blows;

    /// <summary>Still apart, and may meet in the step: see <see cref="PairStage.Touch"/>.</summary>
    public int Ahead;
}
