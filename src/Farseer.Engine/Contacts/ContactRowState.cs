using System;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Contacts;

/// <summary>
/// The rows of contacts, whole. Most of a row that is awake the next narrow phase writes anew, but not if its bodies are put to sleep
/// before: then it is solved as it is when they wake.
/// </summary>
internal static unsafe class ContactRowState
{
    /// <summary>Writes, or reads, whole records.</summary>
    public static void Visit(StateStream s, ContactBundle* records, int count)
    {
        for (int i = 0; i < count && !s.IsReading; i++)
        {
            // What there is in a lane without a contact depends on how many lanes are written at once, and is read by nobody.
            for (int lane = 0; lane < ContactBundle.LineLanes; lane++)
            {
                if (records[i].Contact[lane] < 0)
                {
                    ContactLanes.Rest(records + i, lane);
                }
            }

            ContactLanes.RestMarks(records + i);
        }

        if (s.IsNaming)
        {
            VisitColumns(s, records, count);
        }
        else if (s.HoldsDifferences)
        {
            VisitFolded(s, records, count);
        }
        else
        {
            s.Raw(records, (long)count * ContactBundle.Bytes);
        }
    }

    /// <summary>
    /// For those who keep differences: what nearly follows from other columns is written as what it differs by from that, which is the same
    /// from step to step. Whatever the columns hold comes back bit for bit.
    /// </summary>
    private static void VisitFolded(StateStream s, ContactBundle* records, int count)
    {
        ContactBundle folded;
        for (ContactBundle* end = records + count; records < end; records++)
        {
            if (s.IsReading)
            {
                s.Raw(records, ContactBundle.Bytes);
                Fold(records, records);
                continue;
            }

            Fold(records, &folded);
            byte* k = (byte*)records->K11;
            byte* rate = (byte*)records->FeedRate;
            s.Raw(records, k - (byte*)records);
            s.Raw(folded.K11, 2 * Prefetch.LineBytes);
            s.Raw(records->Friction, rate - (byte*)records->Friction);
            s.Raw(folded.FeedRate, Prefetch.LineBytes);
            s.Raw(records->FeedShare, (byte*)(records + 1) - (byte*)records->FeedShare);
        }
    }

    /// <summary>Turns columns into what they lack of what is likely, and back: each is the likely less the other.</summary>
    private static void Fold(ContactBundle* row, ContactBundle* to)
    {
        // Contacts of an island have the same rate.
        uint first = *(uint*)row->FeedRate;
        Wide* likely = stackalloc Wide[ContactBundle.LineLanes / Wide.Count];
        for (int i = 0; i < ContactBundle.LineLanes / Wide.Count; i++)
        {
            likely[i] = Wide.FromBits((int)first);
        }

        StateBlock.Subtract((uint*)likely, (uint*)row->FeedRate, (uint*)to->FeedRate, ContactBundle.LineLanes);
        *(uint*)to->FeedRate = first;
        Respond(row, &row->Point0, likely);
        StateBlock.Subtract((uint*)likely, (uint*)row->K11, (uint*)to->K11, ContactBundle.LineLanes);
        Respond(row, &row->Point1, likely);
        StateBlock.Subtract((uint*)likely, (uint*)row->K22, (uint*)to->K22, ContactBundle.LineLanes);
    }

    /// <summary>How bodies answer at a point, as <see cref="ContactRowWriter"/> works it out.</summary>
    private static void Respond(ContactBundle* row, ContactPointLanes* point, Wide* responses)
    {
        for (int i = 0; i < ContactBundle.LineLanes / Wide.Count; i++)
        {
            int lane = i * Wide.Count;
            Wide armA = Wide.Load(point->TangentArmA + lane);
            Wide armB = Wide.Load(point->TangentArmB + lane);
            Wide response = Wide.Load(row->MassA + lane) + Wide.Load(row->MassB + lane)
                + (Wide.Load(row->InertiaA + lane) * armA * armA) + (Wide.Load(row->InertiaB + lane) * armB * armB);

            // What is no number may have other bits each time.
            responses[i] = Wide.Keep(response >= Wide.Zero, response);
        }
    }

    /// <summary>The same column by column, each with its name, for those who look for a difference.</summary>
    private static void VisitColumns(StateStream s, ContactBundle* records, int count)
    {
        for (ContactBundle* end = records + count; records < end; records++)
        {
            int* contacts = records->Contact;
            byte* column = (byte*)records;
            Numbers(s, ref column, contacts, nameof(ContactBundle.BodyA), nameof(ContactBundle.BodyB));
            Values(s, ref column, contacts, nameof(ContactBundle.NormalX), nameof(ContactBundle.NormalY), nameof(ContactBundle.MassA),
                nameof(ContactBundle.MassB), nameof(ContactBundle.InertiaA), nameof(ContactBundle.InertiaB), nameof(ContactBundle.RadiusA),
                nameof(ContactBundle.RadiusB));
            VisitPoint(s, ref column, contacts, nameof(ContactBundle.Point0));
            VisitPoint(s, ref column, contacts, nameof(ContactBundle.Point1));
            Values(s, ref column, contacts, nameof(ContactBundle.K11), nameof(ContactBundle.K22), nameof(ContactBundle.Friction));
            Numbers(s, ref column, contacts, nameof(ContactBundle.Flags));
            Values(
                s,
                ref column,
                contacts,
                nameof(ContactBundle.FeedRate),
                nameof(ContactBundle.FeedShare),
                nameof(ContactBundle.Restitution));
            Values(s, ref column, contacts, nameof(ContactBundle.Struck));
            Numbers(s, ref column, contacts, nameof(ContactBundle.Contact), nameof(ContactBundle.PieceA), nameof(ContactBundle.PieceB),
                nameof(ContactBundle.Id0), nameof(ContactBundle.Id1), nameof(ContactBundle.Slot));
            if (column != (byte*)(records + 1))
            {
                throw new InvalidOperationException("The columns of a contact row are others than those that are named here.");
            }
        }
    }

    private static void VisitPoint(StateStream s, ref byte* column, int* contacts, string point)
    {
        string from = point + ".";
        Values(s, ref column, contacts, from + nameof(ContactPointLanes.NormalArmA), from + nameof(ContactPointLanes.TangentArmA),
            from + nameof(
                ContactPointLanes.NormalArmB), from + nameof(ContactPointLanes.TangentArmB), from + nameof(ContactPointLanes.Base));
        Values(s, ref column, contacts, from + nameof(ContactPointLanes.Normal), from + nameof(ContactPointLanes.Tangent),
            from + nameof(
                ContactPointLanes.Feed), from + nameof(ContactPointLanes.PreviousNormal), from + nameof(ContactPointLanes.PreviousTangent));
    }

    private static void Values(StateStream s, ref byte* column, int* contacts, params string[] names)
    {
        foreach (string name in names)
        {
            s.Lanes((float*)column, contacts, ContactBundle.LineLanes, "Contact", name);
            column += Prefetch.LineBytes;
        }
    }

    private static void Numbers(StateStream s, ref byte* column, int* contacts, params string[] names)
    {
        foreach (string name in names)
        {
            s.Lanes((int*)column, contacts, ContactBundle.LineLanes, "Contact", name);
            column += Prefetch.LineBytes;
        }
    }
}
