namespace Farseer.Engine.Accuracy;

/// <summary>What a step's largest error is an error of. The facade's enumeration has the same values.</summary>
internal enum ErrorCause
{
    None,

    /// <summary>Bodies that push each other apart lie in each other.</summary>
    Overlap,

    /// <summary>A rigid joint stands open.</summary>
    Separation,

    /// <summary>A contact that sticks went along its tangent.</summary>
    Slip,

    /// <summary>Impacts left another energy than their law.</summary>
    Impact,

    /// <summary>Impulses within a free group do not cancel.</summary>
    Momentum,

    /// <summary>Bodies went another way than with finer substeps.</summary>
    Motion,

    /// <summary>The numbers of a body left their range.</summary>
    Lost,
}
