using System;
using AnatomyCarve.Volumes;

namespace AnatomyCarve.Formats
{
    /// <summary>
    /// Places a NIfTI-1 grid in the patient: sform before qform before spacing alone, as the standard orders its three methods;
    /// turned from RAS to LPS and from the header's unit to millimetres.
    /// </summary>
    sealed class NiftiGeometry
    {
        /// <summary>sform and qform that place a corner further apart than this really differ; less is the quaternion's rounding.</summary>
        const double RoundingMm = 0.01;

        readonly NiftiHeader header;
        readonly ReadContext context;
        readonly double unitMm;
        readonly VectorMm spacing;

        NiftiGeometry(NiftiHeader header, ReadContext context)
        {
            this.header = header;
            this.context = context;
            unitMm = UnitMm();
            spacing = new VectorMm(Spacing(1), Spacing(2), Spacing(3));
        }

        /// <summary>The grid's place.</summary>
        /// <param name="sizes">Three sizes of at least 1.</param>
        internal static VolumeGeometry Of(NiftiHeader header, int[] sizes, ReadContext context)
        {
            (Affine affine, string field) = new NiftiGeometry(header, context).Place(sizes);
            return context.MakeGeometry(sizes[0], sizes[1], sizes[2], affine, field);
        }

        (Affine IjkToLps, string Field) Place(int[] sizes)
        {
            bool hasSform = header.SformCode > 0 && IsUsable(Sform());
            bool hasQform = header.QformCode > 0 && IsUsable(Qform());
            if (header.SformCode > 0 && !hasSform)
                context.Warn($"The sform ({Sform()}) can't place the voxels; {(hasQform ? "the qform" : "the spacing alone")} is used.");
            if (hasSform && hasQform)
            {
                double apartMm = VolumeGeometry.LargestCornerDistanceMm(Sform(), Qform(), sizes[0], sizes[1], sizes[2]);
                if (apartMm > RoundingMm)
                    context.Warn($"sform and qform place the voxels up to {apartMm:0.###} mm apart; the sform is used, other programs may use the qform.");
            }

            if (hasSform)
                return (Sform(), "srow_x, srow_y, srow_z");
            WarnOfMissingSpacing(sizes);
            if (hasQform)
                return (Qform(), "quatern_b, quatern_c, quatern_d");
            context.Warn($"The header has no orientation (no usable sform or qform): the axes are taken as left, posterior, superior. Left and right may be exchanged.");
            Affine aligned = Affine.FromColumns(
                new VectorMm(spacing.X, 0, 0), new VectorMm(0, spacing.Y, 0), new VectorMm(0, 0, spacing.Z), new PointMm(0, 0, 0));
            return (aligned, "pixdim");
        }

        static bool IsUsable(Affine ijkToLps) => VolumeGeometry.FindProblem(ijkToLps) == null;

        /// <summary>The rows srow_x and srow_y negated (0 - x, so that no element becomes -0), srow_z as it is.</summary>
        Affine Sform()
        {
            double m = unitMm;
            NiftiHeader h = header;
            return new Affine(
                0 - (h.Srow(0, 0) * m), 0 - (h.Srow(0, 1) * m), 0 - (h.Srow(0, 2) * m), 0 - (h.Srow(0, 3) * m),
                0 - (h.Srow(1, 0) * m), 0 - (h.Srow(1, 1) * m), 0 - (h.Srow(1, 2) * m), 0 - (h.Srow(1, 3) * m),
                h.Srow(2, 0) * m, h.Srow(2, 1) * m, h.Srow(2, 2) * m, h.Srow(2, 3) * m);
        }

        /// <summary>The quaternion's rotation as the standard writes it out (nifti1.h, "method 2").</summary>
        Affine Qform()
        {
            double b = header.Quaternion(0);
            double c = header.Quaternion(1);
            double d = header.Quaternion(2);
            double square = (b * b) + (c * c) + (d * d);
            double a = Math.Sqrt(Math.Max(0, 1 - square));
            if (square > 1)
            {
                double length = Math.Sqrt(square);
                b /= length;
                c /= length;
                d /= length;
            }

            double handedness = header.Pixdim(0) < 0 ? -1 : 1;
            VectorMm i = new VectorMm(-((a * a) + (b * b) - (c * c) - (d * d)), -2 * ((b * c) + (a * d)), 2 * ((b * d) - (a * c))) * spacing.X;
            VectorMm j = new VectorMm(-2 * ((b * c) - (a * d)), -((a * a) + (c * c) - (b * b) - (d * d)), 2 * ((c * d) + (a * b))) * spacing.Y;
            VectorMm k = new VectorMm(-2 * ((b * d) + (a * c)), -2 * ((c * d) - (a * b)), (a * a) + (d * d) - (c * c) - (b * b)) * (spacing.Z * handedness);
            var origin = new PointMm(
                -header.QuaternionOffset(0) * unitMm, -header.QuaternionOffset(1) * unitMm, header.QuaternionOffset(2) * unitMm);
            return Affine.FromColumns(i, j, k, origin);
        }

        /// <summary>The spacing along an axis, mm: its absolute value; 1 unit where the header has none.</summary>
        double Spacing(int axis)
        {
            double spacing = Math.Abs(header.Pixdim(axis));
            return (IsSpacing(spacing) ? spacing : 1) * unitMm;
        }

        static bool IsSpacing(double spacing) => spacing > 0 && double.IsFinite(spacing);

        void WarnOfMissingSpacing(int[] sizes)
        {
            for (int axis = 1; axis <= 3; axis++)
            {
                // An axis of one voxel needs no spacing to be placed, and images of two dimensions often give none.
                if (sizes[axis - 1] > 1 && !IsSpacing(Math.Abs(header.Pixdim(axis))))
                    context.Warn($"pixdim[{axis}] is {header.Pixdim(axis)}, no spacing; 1 is used.");
            }
        }

        double UnitMm()
        {
            switch (header.Units & 7)
            {
                case 1:
                    return 1000;
                case 3:
                    return 0.001;
                default:
                    return 1;
            }
        }
    }
}
